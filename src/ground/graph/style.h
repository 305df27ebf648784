// How a picture is to be drawn.
#pragma once

#include "graph/language.h"

namespace merker::graph {

struct Style {
  Language names = Language::German;  // of elements and pins: those of the mnemonics
  int widest = 0;  // columns of ladder; a rung that is wider goes on below; 0: as wide as it is
};

}  // namespace merker::graph
