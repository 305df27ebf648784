#include "mc7/encoding.h"

#include "mc7/field.h"
#include "mc7/operand_class.h"
#include "pattern/index.h"

namespace merker::mc7 {
namespace {

constexpr std::array kRows{
#define ENCODING(operation, bits, operand, source)                               \
  Encoding{pattern::compile<std::uint8_t>(bits), Operation::operation, #operand, \
           operand_class::operand, source},
#include "mc7/encodings.inc"
#undef ENCODING
};

// What no field changes: kind (5 bits), width (2), format of a constant (5), kind of a block (4).
constexpr std::uint16_t operandKey(const Operand& operand) {
  return static_cast<std::uint16_t>(static_cast<unsigned>(operand.kind) << 11 |
                                    static_cast<unsigned>(operand.width) << 9 |
                                    static_cast<unsigned>(operand.format) << 4 |
                                    (static_cast<unsigned>(operand.blockKind) & 0xF));
}

// Encoding: groups are operations, the key is what no field of a pattern changes.
struct ByOperation {
  static constexpr std::size_t kGroups = 0
#define OPERATION(...) +1
#include "mc7/operations.inc"
#undef OPERATION
      ;
  static constexpr pattern::GroupSet groups(const Encoding& row) {
    return {static_cast<std::size_t>(row.operation), 0};
  }
  static constexpr pattern::Entry entry(std::size_t number, const Encoding& row) {
    return {static_cast<std::uint16_t>(number), 0xFFFF, operandKey(row.operand)};
  }
};

constexpr auto kByFirstByte = pattern::makeIndex<kRows, pattern::ByFirstByte>();
constexpr auto kByOperation = pattern::makeIndex<kRows, ByOperation>();

}  // namespace

std::optional<Operand> decodeOperand(const Encoding& row, std::uint64_t code) {
  return pattern::decodeOperand(row, code);
}

std::optional<std::uint64_t> encodeOperand(const Encoding& row, const Operand& operand) {
  if (operandKey(operand) != operandKey(row.operand)) return std::nullopt;
  return pattern::encodeOperand(row, operand);
}

std::span<const Encoding> encodings() { return kRows; }

bool encode(const Encoding& row, const Operand& operand, std::vector<std::uint8_t>& out) {
  const auto code = encodeOperand(row, operand);
  if (code) pattern::append(*code, row.length, out);
  return code.has_value();
}

bool encode(const Instruction& instruction, std::vector<std::uint8_t>& out) {
  const std::uint16_t key = operandKey(instruction.operand);
  for (const pattern::Entry& entry :
       kByOperation.group(static_cast<std::size_t>(instruction.operation)))
    if (entry.bits == key && encode(kRows[entry.row], instruction.operand, out)) return true;
  return false;
}

std::optional<Decoded> decode(std::span<const std::uint8_t> code) {
  return pattern::decode<Decoded>(code, kRows, kByFirstByte);
}

}  // namespace merker::mc7
