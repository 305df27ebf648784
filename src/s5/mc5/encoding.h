// A row of encodings.inc, its pattern taken apart. Codes are handled as 48 bits, the first word on
// top.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mc5/instruction.h"

namespace merker::mc5 {

// A run of the same letter: `bits` bits, `shift` bits above the lowest of the 48.
struct Field {
  char letter = 0;
  std::uint8_t shift = 0, bits = 0;
};

struct Encoding {
  Operation operation = Operation::NOP0;
  std::string_view pattern;                    // as in encodings.inc
  std::string_view operandClass;               // name in operand_class.h
  Operand operand;                             // what no field fills in
  std::array<std::uint32_t, 4> nanoseconds{};  // COP shortest, longest, ACOP shortest, longest
  std::string_view source;                     // section of the manual

  std::uint64_t mask = 0, bits = 0;  // of the fixed bits
  unsigned words = 0;
  std::array<Field, 3> fields{};
  unsigned fieldCount = 0;
};

// The operand in `code` if the row fits it.
std::optional<Operand> decodeOperand(const Encoding& row, std::uint64_t code);
// The code of the operand; nothing if the row has no place for it.
std::optional<std::uint64_t> encodeOperand(const Encoding& row, const Operand& operand);

}  // namespace merker::mc5
