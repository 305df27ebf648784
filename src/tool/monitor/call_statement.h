// CALL of the source, which the compiler makes several instructions of (MC7 section 7.2): BLD 1 to
// BLD 2 around the call of a function, BLD 3 to BLD 4 around that of a function block.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "address/area.h"

namespace merker::monitor {

struct CallStatement {
  std::uint32_t end = 0;  // bytes of code, behind its last instruction
  std::string text;       // "CALL  FB 1, DB 10"
};

// The CALL that begins at `at` and ends before `end`, the next statement.
std::optional<CallStatement> callStatement(std::span<const std::uint8_t> code, std::uint32_t at,
                                           std::uint32_t end, Mnemonics mnemonics);

}  // namespace merker::monitor
