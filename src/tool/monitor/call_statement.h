// CALL of the source, which the compiler makes several instructions of: from one BLD to the next
// number (MC7 section 7.3; code patterns, sections 2 and 3).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "address/area.h"

namespace merker::monitor {

struct CallStatement {
  std::uint32_t end = 0;       // bytes of code, behind its last instruction
  std::string text;            // "CALL  FB 1, DB 10"
  std::int32_t instance = -1;  // number of its data block
};

// The CALL that begins at `at` and ends before `end`, the next statement.
std::optional<CallStatement> callStatement(std::span<const std::uint8_t> code, std::uint32_t at,
                                           std::uint32_t end, Mnemonics mnemonics);

}  // namespace merker::monitor
