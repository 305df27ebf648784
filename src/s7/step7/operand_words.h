// The words of operands in both mnemonics (S7-MNE-11, S7-MNE-12).
#pragma once

#include <optional>
#include <string_view>

#include "address/area.h"
#include "mc7/operand.h"

namespace merker::step7 {

struct MemoryWord {
  std::string_view de, en;
  Area area;
  Width width;
  bool peripheralOutput = false;
};

// EB, DBX, PIW … in any case; nothing for other words. `which` is set when the word exists in one
// setting only.
const MemoryWord* findMemoryWord(std::string_view word, std::optional<Mnemonics>& which);
std::optional<mc7::StatusQuery> findStatusWord(std::string_view word,
                                               std::optional<Mnemonics>& which);
std::optional<mc7::DataBlockQuery> findDataBlockQuery(std::string_view word);

}  // namespace merker::step7
