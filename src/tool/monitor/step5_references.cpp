#include "monitor/step5_references.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mc5/block_id.h"
#include "mc5/operand_text.h"
#include "mc5/place.h"
#include "step5/declaration.h"

namespace merker::monitor {
namespace {

using mc5::Operand;
using mc5::OperandKind;
using mc5::Operation;

constexpr Operation kWrites[] = {
    Operation::ASSIGN,     Operation::SET_BIT,          Operation::RESET_BIT,
    Operation::TRANSFER,   Operation::TIMER_SI,         Operation::TIMER_SV,
    Operation::TIMER_SE,   Operation::TIMER_SS,         Operation::TIMER_SA,
    Operation::COUNT_UP,   Operation::COUNT_DOWN,       Operation::ENABLE,
    Operation::SET_ALWAYS, Operation::RESET_ALWAYS,     Operation::RESET_DIGITAL,
    Operation::START_SVZ,  Operation::RESET_FORMAL_BIT, Operation::START_SSV,
    Operation::START_SAR};

Use useOf(Operation operation) {
  return std::ranges::find(kWrites, operation) != std::end(kWrites) ? Use::Write : Use::Read;
}

// B =X opens a data block or calls a block.
Use useOfFormal(Operation operation) {
  return operation == Operation::SUBSTITUTE ? Use::Call : useOf(operation);
}

// Of a function block whose code does not say.
Use useOf(const mc5::Parameter& parameter) {
  return parameter.kind == mc5::ParameterKind::Output ? Use::Write : Use::Read;
}

bool isOperand(const Operand& operand) {
  return operand.kind == OperandKind::Memory || operand.kind == OperandKind::Timer ||
         operand.kind == OperandKind::Counter;
}

// B DW, B MW: the next instruction gets its operand from there (S5-PROC-01).
bool substitutesNext(const mc5::Instruction& one) {
  return one.operation == Operation::SUBSTITUTE && one.operand.kind != OperandKind::Formal;
}

}  // namespace

const FormalUses::Of& FormalUses::of(const mc5::Block& block) {
  const auto [found, fresh] = blocks_.try_emplace(&block);
  if (!fresh) return found->second;
  Of& uses = found->second;
  for (const Step5Instruction& one : step5Instructions(block)) {
    const Operation operation = one.instruction.operation;
    const bool formal = one.instruction.operand.kind == OperandKind::Formal;
    uses.opens |= operation == Operation::OPEN || (formal && operation == Operation::SUBSTITUTE);
    if (!formal) continue;
    const Use use = useOfFormal(operation);
    const auto [old, first] = uses.words.try_emplace(one.instruction.operand.value, use);
    if (!first && old->second != use) old->second = Use::ReadWrite;
  }
  return uses;
}

Step5References::Step5References(const mc5::Block& block, const Surroundings& around)
    : block_(block), around_(around), rows_(block, around.symbols, around.out) {
  const auto words = step5::parameterWords(block.parameters);
  for (std::size_t i = 0; i < words.size(); ++i) names_[words[i]] = block.parameters[i].name;
}

void Step5References::run() {
  const std::vector<Step5Instruction> code = step5Instructions(block_);
  findTargets(code);
  for (const Step5Instruction& one : code) instruction(one);
}

void Step5References::findTargets(const std::vector<Step5Instruction>& code) {
  bool substituted = false;
  for (const Step5Instruction& one : code) {
    const Operand& operand = one.instruction.operand;
    if (operand.kind == OperandKind::Jump) {
      anyTarget_ |= substituted;
      targets_.insert(one.offset + operand.value);  // two's complement
    }
    substituted = substitutesNext(one.instruction);
  }
}

void Step5References::instruction(const Step5Instruction& one) {
  const mc5::Instruction& what = one.instruction;
  const Operand& operand = what.operand;
  const bool substituted = std::exchange(substitutes_, substitutesNext(what));
  rows_.arrive(one.offset);
  if (anyTarget_ || targets_.contains(one.offset)) db_ = -1;
  if (!substituted) {
    if (isOperand(operand)) add(operand, useOf(what.operation), db_, what);
    if (operand.kind == OperandKind::Block) add(operand, Use::Call, -1, what);
    if (operand.kind == OperandKind::Formal) formal(what);
    actualOperands(one);
  }
  open(what, substituted);
}

// A block that is called gives the data block of its caller back (S5-DB-07); so does B =X if it
// calls one, but it may open one instead.
void Step5References::open(const mc5::Instruction& one, bool substituted) {
  const bool formal =
      one.operation == Operation::SUBSTITUTE && one.operand.kind == OperandKind::Formal;
  if (one.operation == Operation::OPEN && !substituted)
    db_ = static_cast<std::int32_t>(one.operand.value);
  else if (one.operation == Operation::OPEN || formal)
    db_ = -1;
}

// A word of the list is the code of an instruction with the operand (S5-FB-16). Data of the block
// that is open at the call, unless the function block opens one itself.
void Step5References::actualOperands(const Step5Instruction& call) {
  const mc5::Block* const called = calledFunctionBlock(around_.program, call.instruction);
  if (called == nullptr) return;
  const FormalUses::Of& uses = around_.formals.of(*called);
  const auto words = step5::parameterWords(called->parameters);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const mc5::Parameter& parameter = called->parameters[i];
    if (parameter.kind == mc5::ParameterKind::Data || words[i] > call.list.size()) continue;
    const auto actual = mc5::decode(call.list.subspan(words[i] - 1, 1));
    if (!actual) continue;
    const Operand& operand = actual->instruction.operand;
    const auto known = uses.words.find(words[i]);
    const Use use = known == uses.words.end() ? useOf(parameter) : known->second;
    if (isOperand(operand)) add(operand, use, uses.opens ? -1 : db_, call.instruction);
    if (operand.kind == OperandKind::Block) add(operand, Use::Call, -1, call.instruction);
  }
}

void Step5References::formal(const mc5::Instruction& one) {
  const auto name = names_.find(one.operand.value);
  if (name == names_.end()) return;
  CrossReference row;
  row.operand = "=" + name->second;
  row.block = blockId(block_);
  row.formal = one.operand.value;
  rows_.add(std::move(row), useOfFormal(one.operation), text(one));
}

void Step5References::add(const Operand& operand, Use use, std::int32_t db,
                          const mc5::Instruction& one) {
  CrossReference row;
  row.key = mc5::placeOf(operand);
  row.operand = mc5::operandText(operand);
  if (operand.kind == OperandKind::Block)
    row.block = mc5::neutralId({operand.block, static_cast<std::uint16_t>(operand.value)});
  if (operand.area == mc5::Area::Data && db >= 0) {
    row.db = db;
    row.operand = fmt::format("DB{}.{}", db, row.operand);
  }
  rows_.add(std::move(row), use, text(one));
}

// Formal operands by their names.
std::string Step5References::text(const mc5::Instruction& one) const {
  const auto name = names_.find(one.operand.value);
  if (one.operand.kind != OperandKind::Formal || name == names_.end()) return mc5::text(one);
  return fmt::format("{:<5} ={}", mc5::info(one.operation).name, name->second);
}

}  // namespace merker::monitor
