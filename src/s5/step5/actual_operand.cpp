#include "step5/actual_operand.h"

#include "mc5/constant.h"
#include "mc5/instruction.h"
#include "mc5/range.h"

namespace merker::step5 {
namespace {

using mc5::Area;
using mc5::Instruction;
using mc5::OperandKind;
using mc5::Operation;
using mc5::Parameter;
using mc5::ParameterKind;
using mc5::Width;

bool isImage(Area area) {
  return area == Area::Input || area == Area::Output || area == Area::Flag;
}

bool fitsWidth(Width parameter, const mc5::Operand& operand) {
  switch (parameter) {
    case Width::Bit:
      return operand.width == Width::Bit && isImage(operand.area);
    case Width::Byte:
      return operand.width == Width::Byte || operand.width == Width::Left ||
             operand.width == Width::Right;
    case Width::Word:
      return operand.width == Width::Word;
    default:
      return operand.width == Width::Double;
  }
}

// The instruction whose code stands in the list; nothing if the operand is of another kind.
std::optional<Instruction> carrier(const Parameter& parameter, const mc5::Operand& operand) {
  const OperandKind kind = operand.kind;
  switch (parameter.kind) {
    case ParameterKind::Input:
    case ParameterKind::Output:
      if (kind != OperandKind::Memory || !fitsWidth(parameter.width, operand)) return std::nullopt;
      return Instruction{parameter.width == Width::Bit ? Operation::AND : Operation::LOAD, operand};
    case ParameterKind::Timer:
      if (kind != OperandKind::Timer || operand.width == Width::Bit) return std::nullopt;
      return Instruction{Operation::LOAD, operand};
    case ParameterKind::Counter:
      if (kind != OperandKind::Counter || operand.width == Width::Bit) return std::nullopt;
      return Instruction{Operation::LOAD, operand};
    case ParameterKind::Block:
      if (kind != OperandKind::Block) return std::nullopt;
      return Instruction{operand.block == mc5::BlockType::Db ? Operation::OPEN : Operation::CALL,
                         operand};
    case ParameterKind::Data:
      break;
  }
  return std::nullopt;
}

bool appendConstant(const Parameter& parameter, const mc5::Operand& operand,
                    std::vector<std::uint16_t>& words) {
  if (operand.kind != OperandKind::Constant || operand.format != parameter.format) return false;
  if (parameter.format == mc5::Format::Float)
    words.push_back(static_cast<std::uint16_t>(operand.value >> 16));
  words.push_back(static_cast<std::uint16_t>(operand.value));
  return true;
}

// PB 3 is a program block for a parameter of kind B.
mc5::Operand adjusted(const Parameter& parameter, const Operand& actual) {
  const mc5::Operand& operand = actual.value;
  if (actual.symbol) return operand;
  const bool periphery = operand.kind == OperandKind::Memory && operand.area == Area::Peripheral;
  if (parameter.kind != ParameterKind::Block || !periphery || operand.width != Width::Byte)
    return operand;
  return {.kind = OperandKind::Block, .block = mc5::BlockType::Pb, .value = operand.value};
}

}  // namespace

bool appendActual(const Parameter& parameter, const Operand& actual,
                  std::vector<std::uint16_t>& words) {
  if (!actual.name.empty()) return false;
  if (parameter.kind == ParameterKind::Data) return appendConstant(parameter, actual.value, words);
  const auto instruction = carrier(parameter, adjusted(parameter, actual));
  return instruction && mc5::inRange(*instruction) && mc5::encode(*instruction, words);
}

bool outOfRange(const Parameter& parameter, const Operand& actual, mc5::Range& range) {
  if (!actual.name.empty() || parameter.kind == ParameterKind::Data) return false;
  const auto instruction = carrier(parameter, adjusted(parameter, actual));
  if (!instruction || mc5::inRange(*instruction)) return false;
  range = mc5::rangeOf(*instruction);
  return true;
}

std::string_view possibleOperands(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::Timer:
      return "T 0..31";
    case ParameterKind::Counter:
      return "Z 0..31";
    case ParameterKind::Block:
      return "DB, FB, PB, SB with a number";
    case ParameterKind::Data:
      return mc5::info(parameter.format).range;
    default:
      break;
  }
  switch (parameter.width) {
    case Width::Bit:
      return "E, A, M with a bit: E 10.3";
    case Width::Byte:
      return "EB, AB, MB, DL, DR, PB";
    case Width::Word:
      return "EW, AW, MW, DW, PW";
    default:
      return "ED, AD, MD, DD";
  }
}

}  // namespace merker::step5
