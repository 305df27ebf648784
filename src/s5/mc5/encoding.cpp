#include "mc5/encoding.h"

#include "mc5/field.h"
#include "mc5/operand_class.h"

namespace merker::mc5 {
namespace {

constexpr unsigned kCodeBits = 48;

constexpr std::uint32_t nanoseconds(double microseconds) {
  return static_cast<std::uint32_t>(microseconds * 1000 + 0.5);
}

// Takes the pattern apart: "0111 0aaa" gives mask 1111 1000, bits 0111 0000 and the field a.
constexpr Encoding compile(Encoding row) {
  unsigned position = kCodeBits;
  for (const char c : row.pattern) {
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
  row.words = (kCodeBits - position) / 16;
  return row;
}

constexpr std::array kRows{
#define ENCODING(operation, pattern, operand, cop0, cop1, acop0, acop1, source)            \
  compile({Operation::operation,                                                           \
           pattern,                                                                        \
           #operand,                                                                       \
           operand_class::operand,                                                         \
           {nanoseconds(cop0), nanoseconds(cop1), nanoseconds(acop0), nanoseconds(acop1)}, \
           source}),
#include "mc5/encodings.inc"
#undef ENCODING
};

// Rows that fit a first byte, in the order of the table.
struct Index {
  std::array<std::uint16_t, 257> start{};
  std::array<std::uint8_t, kRows.size() * 4> rows{};
};

constexpr bool fitsByte(const Encoding& row, std::size_t firstByte) {
  return ((std::uint64_t{firstByte} << 40 ^ row.bits) & row.mask & 0xFF0000000000) == 0;
}

constexpr Index makeIndex() {
  Index index;
  std::uint16_t next = 0;
  for (std::size_t byte = 0; byte < 256; ++byte) {
    for (std::size_t i = 0; i < kRows.size(); ++i)
      if (fitsByte(kRows[i], byte)) index.rows[next++] = static_cast<std::uint8_t>(i);
    index.start[byte + 1] = next;
  }
  return index;
}

constexpr Index kIndex = makeIndex();
static_assert(kRows.size() <= 256);

std::span<const std::uint8_t> rowsOf(std::uint16_t firstWord) {
  const std::size_t byte = firstWord >> 8;
  return std::span{kIndex.rows}.subspan(
      kIndex.start[byte], static_cast<std::size_t>(kIndex.start[byte + 1] - kIndex.start[byte]));
}

std::uint32_t fieldMask(const Field& field) {
  return static_cast<std::uint32_t>((std::uint64_t{1} << field.bits) - 1);
}

// The first three words of the code on top of each other, missing ones as 0.
std::uint64_t fetch(std::span<const std::uint16_t> code) {
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < 3; ++i) result = result << 16 | (i < code.size() ? code[i] : 0);
  return result;
}

}  // namespace

std::optional<Operand> decodeOperand(const Encoding& row, std::uint64_t code) {
  if ((code & row.mask) != row.bits) return std::nullopt;
  Operand operand = row.operand;
  for (unsigned i = 0; i < row.fieldCount; ++i) {
    const Field& field = row.fields[i];
    const auto number = static_cast<std::uint32_t>(code >> field.shift) & fieldMask(field);
    if (!decodeField(field, number, operand)) return std::nullopt;
  }
  return operand;
}

std::optional<std::uint64_t> encodeOperand(const Encoding& row, const Operand& operand) {
  std::uint64_t code = row.bits;
  for (unsigned i = 0; i < row.fieldCount; ++i) {
    const Field& field = row.fields[i];
    code |= std::uint64_t{encodeField(field, operand) & fieldMask(field)} << field.shift;
  }
  // Whatever the fields have no place for shows up here as a difference.
  if (decodeOperand(row, code) != operand) return std::nullopt;
  return code;
}

std::span<const Encoding> encodings() { return kRows; }

bool encode(const Encoding& row, const Operand& operand, std::vector<std::uint16_t>& out) {
  const auto code = encodeOperand(row, operand);
  for (unsigned i = 0; code && i < row.words; ++i)
    out.push_back(static_cast<std::uint16_t>(*code >> (32 - 16 * i)));
  return code.has_value();
}

bool encode(const Instruction& instruction, std::vector<std::uint16_t>& out) {
  for (const Encoding& row : kRows)
    if (row.operation == instruction.operation && encode(row, instruction.operand, out))
      return true;
  return false;
}

std::optional<Decoded> decode(std::span<const std::uint16_t> code) {
  if (code.empty()) return std::nullopt;
  const std::uint64_t bits = fetch(code);
  for (const std::uint8_t number : rowsOf(code[0])) {
    const Encoding& row = kRows[number];
    if (row.words > code.size()) continue;
    if (const auto operand = decodeOperand(row, bits))
      return Decoded{{row.operation, *operand}, &row, row.words};
  }
  return std::nullopt;
}

bool beginsInstruction(std::uint16_t word) {
  constexpr std::uint64_t kFirstWord = 0xFFFF00000000;
  for (const std::uint8_t number : rowsOf(word)) {
    const Encoding& row = kRows[number];
    if (((std::uint64_t{word} << 32 ^ row.bits) & row.mask & kFirstWord) == 0) return true;
  }
  return false;
}

Times times(const Encoding& row, Variant variant) {
  const std::size_t first = variant == Variant::Cop ? 0 : 2;
  return {Duration{row.nanoseconds[first]}, Duration{row.nanoseconds[first + 1]}};
}

}  // namespace merker::mc5
