// Bit patterns of machine code, taken apart at compile time, and operands decoded and encoded by
// them. Codes are handled as 48 bits, the first unit of the code, a byte or a word, on top.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace merker::pattern {

constexpr unsigned kCodeBits = 48;
template <typename Unit>
constexpr unsigned kUnitBits = 8 * sizeof(Unit);

// A run of the same letter: `bits` bits, `shift` bits above the lowest of the 48.
struct Field {
  char letter = 0;
  std::uint8_t shift = 0, bits = 0;
  constexpr std::uint32_t mask() const {
    return static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
  }
};

// The first part of a row; the rest is an `operation` and an `operand`, what no field fills in.
// decodeField() and encodeField(), beside the type of the operand, give the letters their meaning.
template <typename CodeUnit>
struct Pattern {
  using Unit = CodeUnit;
  std::string_view pattern;          // as written
  std::uint64_t mask = 0, bits = 0;  // of the fixed bits
  unsigned length = 0;               // units of code
  std::array<Field, 4> fields{};
  unsigned fieldCount = 0;
};

// "0111 0aaa" gives mask 1111 1000, bits 0111 0000 and the field a.
template <typename Unit>
constexpr Pattern<Unit> compile(std::string_view text) {
  Pattern<Unit> row{text};
  unsigned position = kCodeBits;
  for (const char c : text) {
    if (c == ' ') continue;
    --position;
    if (c == '0' || c == '1') {
      row.mask |= std::uint64_t{1} << position;
      row.bits |= std::uint64_t{c == '1' ? 1u : 0u} << position;
      continue;
    }
    if (row.fieldCount == 0 || row.fields[row.fieldCount - 1].letter != c)
      row.fields[row.fieldCount++].letter = c;
    Field& field = row.fields[row.fieldCount - 1];
    field.shift = static_cast<std::uint8_t>(position);
    ++field.bits;
  }
  row.length = (kCodeBits - position) / kUnitBits<Unit>;
  return row;
}

template <typename Row>
using OperandOf = decltype(Row::operand);

// The operand in `code` if the row fits it: fixed bits as in the pattern, every field within its
// limits.
template <typename Row>
std::optional<OperandOf<Row>> decodeOperand(const Row& row, std::uint64_t code) {
  if ((code & row.mask) != row.bits) return std::nullopt;
  OperandOf<Row> operand = row.operand;
  for (unsigned i = 0; i < row.fieldCount; ++i) {
    const Field& field = row.fields[i];
    const auto number = static_cast<std::uint32_t>(code >> field.shift) & field.mask();
    if (!decodeField(field.letter, number, operand)) return std::nullopt;
  }
  return operand;
}

// The code of the operand; nothing if the row has no place for it.
template <typename Row>
std::optional<std::uint64_t> encodeOperand(const Row& row, const OperandOf<Row>& operand) {
  std::uint64_t code = row.bits;
  for (unsigned i = 0; i < row.fieldCount; ++i) {
    const Field& field = row.fields[i];
    const std::optional<std::uint32_t> number = encodeField(field.letter, operand);
    if (!number || *number > field.mask()) return std::nullopt;
    code |= std::uint64_t{*number} << field.shift;
  }
  // Whatever the fields have no place for shows up here as a difference.
  if (pattern::decodeOperand(row, code) != operand) return std::nullopt;
  return code;
}

// The first units of the code on top of each other, missing ones as 0.
template <typename Unit>
std::uint64_t fetch(std::span<const Unit> code) {
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < kCodeBits / kUnitBits<Unit>; ++i)
    result = result << kUnitBits<Unit> | (i < code.size() ? code[i] : 0);
  return result;
}

template <typename Unit>
void append(std::uint64_t code, unsigned length, std::vector<Unit>& out) {
  for (unsigned i = 1; i <= length; ++i)
    out.push_back(static_cast<Unit>(code >> (kCodeBits - kUnitBits<Unit> * i)));
}

}  // namespace merker::pattern
