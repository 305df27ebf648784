// What a source shows of both mnemonics while it is read in one (S7-SRC-10).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/problem.h"

namespace merker::step7 {

struct MnemonicUse {
  std::optional<Problem> foreign;  // the first word that exists in the other mnemonics only
  std::vector<Problem> ambiguous;  // words that are another instruction there: SE
};

}  // namespace merker::step7
