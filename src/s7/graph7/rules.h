// What KOP and FUP of STEP 7 know.
#pragma once

#include "address/area.h"
#include "graph/language.h"
#include "graph/rules.h"

namespace merker::graph7 {

const graph::Rules& rules();

// STEP 7 names elements and pins as the mnemonics are: SE is an on-delay in German, an extended
// pulse in English.
inline graph::Language namesIn(Mnemonics mnemonics) {
  return mnemonics == Mnemonics::German ? graph::Language::German : graph::Language::English;
}

}  // namespace merker::graph7
