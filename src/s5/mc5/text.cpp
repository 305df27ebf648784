// An instruction as one line of a listing.
#include <fmt/format.h>

#include <array>

#include "mc5/block_id.h"
#include "mc5/constant.h"
#include "mc5/instruction.h"
#include "mc5/operand_text.h"

namespace merker::mc5 {
namespace {

struct MemoryName {
  Area area;
  Width width;
  std::string_view name;
};
constexpr std::array kMemoryNames{
    MemoryName{Area::Input, Width::Bit, "E"},       MemoryName{Area::Input, Width::Byte, "EB"},
    MemoryName{Area::Input, Width::Word, "EW"},     MemoryName{Area::Input, Width::Double, "ED"},
    MemoryName{Area::Output, Width::Bit, "A"},      MemoryName{Area::Output, Width::Byte, "AB"},
    MemoryName{Area::Output, Width::Word, "AW"},    MemoryName{Area::Output, Width::Double, "AD"},
    MemoryName{Area::Flag, Width::Bit, "M"},        MemoryName{Area::Flag, Width::Byte, "MB"},
    MemoryName{Area::Flag, Width::Word, "MW"},      MemoryName{Area::Flag, Width::Double, "MD"},
    MemoryName{Area::Data, Width::Bit, "D"},        MemoryName{Area::Data, Width::Left, "DL"},
    MemoryName{Area::Data, Width::Right, "DR"},     MemoryName{Area::Data, Width::Word, "DW"},
    MemoryName{Area::Data, Width::Double, "DD"},    MemoryName{Area::Peripheral, Width::Byte, "PB"},
    MemoryName{Area::Peripheral, Width::Word, "PW"}};

std::string memoryText(const Operand& operand) {
  for (const MemoryName& row : kMemoryNames) {
    if (row.area != operand.area || row.width != operand.width) continue;
    if (operand.width == Width::Bit)
      return fmt::format("{} {}.{}", row.name, operand.value, operand.bit);
    return fmt::format("{} {}", row.name, operand.value);
  }
  return "?";
}

std::string cellText(char letter, const Operand& operand) {
  if (operand.width == Width::Bit)
    return fmt::format("{} {}.{}", letter, operand.value, operand.bit);
  return fmt::format("{} {}", letter, operand.value);
}

}  // namespace

std::string operandText(const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::None:
      return {};
    case OperandKind::Memory:
      return memoryText(operand);
    case OperandKind::Timer:
      return cellText('T', operand);
    case OperandKind::Counter:
      return cellText('Z', operand);
    case OperandKind::Constant:
      return constantText(operand);
    case OperandKind::Count:
      return std::to_string(operand.value);
    case OperandKind::Jump:
      return fmt::format("={:+}", static_cast<std::int32_t>(operand.value));
    case OperandKind::Block:
      return toString(BlockId{operand.block, static_cast<std::uint16_t>(operand.value)});
    case OperandKind::Formal:
      return fmt::format("={}", operand.value);
  }
  return {};
}

std::string text(const Instruction& instruction) {
  const std::string operand = operandText(instruction.operand);
  const std::string_view name = info(instruction.operation).name;
  if (operand.empty()) return std::string(name);
  return fmt::format("{:<5} {}", name, operand);
}

}  // namespace merker::mc5
