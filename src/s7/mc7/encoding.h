// A row of encodings.inc, its pattern taken apart.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mc7/instruction.h"
#include "pattern/pattern.h"

namespace merker::mc7 {

using pattern::Field;

struct Encoding : pattern::Pattern<std::uint8_t> {
  Operation operation = Operation::NOP0;
  std::string_view operandClass;  // name in operand_class.h
  Operand operand;                // what no field fills in
  std::string_view source;        // section of the MC7 description
};

// The operand in `code` if the row fits it: fixed bits as in the pattern, every field within its
// limits.
std::optional<Operand> decodeOperand(const Encoding& row, std::uint64_t code);
// The code of the operand; nothing if the row has no place for it.
std::optional<std::uint64_t> encodeOperand(const Encoding& row, const Operand& operand);

}  // namespace merker::mc7
