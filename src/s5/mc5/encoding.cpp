#include "mc5/encoding.h"

#include "mc5/field.h"
#include "mc5/operand_class.h"
#include "pattern/index.h"

namespace merker::mc5 {
namespace {

constexpr std::uint32_t nanoseconds(double microseconds) {
  return static_cast<std::uint32_t>(microseconds * 1000 + 0.5);
}

constexpr std::array kRows{
#define ENCODING(operation, bits, operand, cop0, cop1, acop0, acop1, source)               \
  Encoding{pattern::compile<std::uint16_t>(bits),                                          \
           Operation::operation,                                                           \
           #operand,                                                                       \
           operand_class::operand,                                                         \
           {nanoseconds(cop0), nanoseconds(cop1), nanoseconds(acop0), nanoseconds(acop1)}, \
           source},
#include "mc5/encodings.inc"
#undef ENCODING
};

constexpr auto kByFirstByte = pattern::makeIndex<kRows, pattern::ByFirstByte>();

}  // namespace

std::optional<Operand> decodeOperand(const Encoding& row, std::uint64_t code) {
  return pattern::decodeOperand(row, code);
}

std::optional<std::uint64_t> encodeOperand(const Encoding& row, const Operand& operand) {
  return pattern::encodeOperand(row, operand);
}

std::span<const Encoding> encodings() { return kRows; }

bool encode(const Encoding& row, const Operand& operand, std::vector<std::uint16_t>& out) {
  const auto code = encodeOperand(row, operand);
  if (code) pattern::append(*code, row.length, out);
  return code.has_value();
}

bool encode(const Instruction& instruction, std::vector<std::uint16_t>& out) {
  for (const Encoding& row : kRows)
    if (row.operation == instruction.operation && encode(row, instruction.operand, out))
      return true;
  return false;
}

std::optional<Decoded> decode(std::span<const std::uint16_t> code) {
  return pattern::decode<Decoded>(code, kRows, kByFirstByte);
}

bool beginsInstruction(std::uint16_t word) {
  for (const pattern::Entry& entry : kByFirstByte.group(word >> 8))
    if (entry.fits(word)) return true;
  return false;
}

Times times(const Encoding& row, Variant variant) {
  const std::size_t first = variant == Variant::Cop ? 0 : 2;
  return {Duration{row.nanoseconds[first]}, Duration{row.nanoseconds[first + 1]}};
}

}  // namespace merker::mc5
