// How a picture is to be drawn.
#pragma once

#include "graph/language.h"

namespace merker::graph {

struct Style {
  Language language = Language::German;
};

}  // namespace merker::graph
