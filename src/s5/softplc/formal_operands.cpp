// Instructions with a formal operand: the word of the parameter list is the code of an instruction
// whose operand they take (S5-FB-15 … -17, S5-SUBST).
#include "softplc/formal_operands.h"

#include <algorithm>
#include <array>

#include "mc5/encoding.h"
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::Operand;
using mc5::OperandKind;
using mc5::Operation;

enum class Wants : std::uint8_t { Bit, BitOrCell, Value, Cell, TimerOnly };

// What an operation becomes with a timer or bit or value, and with a counter.
struct Row {
  Operation formal;
  Wants wants;
  Operation becomes, withCounter;
};
constexpr std::array kFormalOperandsRows{
    Row{Operation::AND, Wants::BitOrCell, Operation::AND, Operation::AND},
    Row{Operation::AND_NOT, Wants::BitOrCell, Operation::AND_NOT, Operation::AND_NOT},
    Row{Operation::OR, Wants::BitOrCell, Operation::OR, Operation::OR},
    Row{Operation::OR_NOT, Wants::BitOrCell, Operation::OR_NOT, Operation::OR_NOT},
    Row{Operation::SET_BIT, Wants::Bit, Operation::SET_BIT, Operation::SET_BIT},
    Row{Operation::RESET_FORMAL_BIT, Wants::Bit, Operation::RESET_BIT, Operation::RESET_BIT},
    Row{Operation::ASSIGN, Wants::Bit, Operation::ASSIGN, Operation::ASSIGN},
    Row{Operation::LOAD, Wants::Value, Operation::LOAD, Operation::LOAD},
    Row{Operation::TRANSFER, Wants::Value, Operation::TRANSFER, Operation::TRANSFER},
    Row{Operation::LOAD_BCD, Wants::Cell, Operation::LOAD_BCD, Operation::LOAD_BCD},
    Row{Operation::TIMER_SI, Wants::TimerOnly, Operation::TIMER_SI, Operation::TIMER_SI},
    Row{Operation::TIMER_SE, Wants::TimerOnly, Operation::TIMER_SE, Operation::TIMER_SE},
    Row{Operation::ENABLE, Wants::Cell, Operation::ENABLE, Operation::ENABLE},
    Row{Operation::RESET_DIGITAL, Wants::Cell, Operation::RESET_BIT, Operation::RESET_BIT},
    Row{Operation::START_SVZ, Wants::Cell, Operation::TIMER_SV, Operation::SET_BIT},
    Row{Operation::START_SSV, Wants::Cell, Operation::TIMER_SS, Operation::COUNT_UP},
    Row{Operation::START_SAR, Wants::Cell, Operation::TIMER_SA, Operation::COUNT_DOWN}};

bool fits(Wants wants, const Instruction& actual) {
  const OperandKind kind = actual.operand.kind;
  const bool load = actual.operation == Operation::LOAD;
  const bool timer = load && kind == OperandKind::Timer;
  const bool cell = timer || (load && kind == OperandKind::Counter);
  const bool bit = actual.operation == Operation::AND && kind == OperandKind::Memory;
  switch (wants) {
    case Wants::Bit:
      return bit;
    case Wants::BitOrCell:
      return bit || cell;
    case Wants::Value:
      return load && kind == OperandKind::Memory;
    case Wants::Cell:
      return cell;
    case Wants::TimerOnly:
      return timer;
  }
  return false;
}

bool mismatch(Processor& p, std::uint16_t word) {
  return p.fail(Alarm::Substitution, p.opcode(), word);
}

// LW loads the word of the list as it is, LD two of them (S5-FB-17).
bool loadRaw(Processor& p, const Instruction& i, std::uint16_t word) {
  if (i.operation == Operation::LOAD_WORD) {
    p.registers().load(word);
    return true;
  }
  const auto second = p.parameter(i.operand.value + 1);
  p.registers().load(std::uint32_t{word} << 16 | second.value_or(0));
  return true;
}

}  // namespace

// B =X opens a data block or calls a block.
std::optional<Instruction> actualInstruction(const Instruction& formal, std::uint16_t word) {
  const std::uint16_t code[] = {word};
  const auto actual = mc5::decode(code);
  if (!actual) return std::nullopt;
  const Instruction& i = actual->instruction;
  if (formal.operation == Operation::SUBSTITUTE) {
    const bool block = i.operation == Operation::OPEN || i.operation == Operation::CALL;
    return block ? std::optional(i) : std::nullopt;
  }
  const auto row = std::ranges::find(kFormalOperandsRows, formal.operation, &Row::formal);
  if (row == kFormalOperandsRows.end() || !fits(row->wants, i)) return std::nullopt;
  const bool counter = i.operand.kind == OperandKind::Counter;
  return Instruction{counter ? row->withCounter : row->becomes, i.operand};
}

const mc5::Encoding* rowOf(const Instruction& instruction) {
  for (const mc5::Encoding& row : mc5::encodings())
    if (row.operation == instruction.operation &&
        mc5::encodeOperand(row, instruction.operand).has_value())
      return &row;
  return nullptr;
}

bool substituteFormal(Processor& p, const Instruction& i) {
  const auto word = p.parameter(i.operand.value);
  if (!word) return mismatch(p, 0);
  if (i.operation == Operation::LOAD_WORD || i.operation == Operation::LOAD_DOUBLE)
    return loadRaw(p, i, *word);
  const auto actual = actualInstruction(i, *word);
  return actual ? p.substitute(*actual) : mismatch(p, *word);
}

}  // namespace merker::sinumerik
