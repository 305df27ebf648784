#include "monitor/step7_references.h"

#include <fmt/format.h>

#include <algorithm>

#include "mc7/operand_text.h"
#include "mc7/place.h"

namespace merker::monitor {
namespace {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

constexpr Operation kWrites[] = {Operation::ASSIGN,   Operation::SET_BIT,  Operation::RESET_BIT,
                                 Operation::TRANSFER, Operation::TIMER_SI, Operation::TIMER_SV,
                                 Operation::TIMER_SE, Operation::TIMER_SS, Operation::TIMER_SA,
                                 Operation::ENABLE,   Operation::COUNT_UP, Operation::COUNT_DOWN,
                                 Operation::TAR1,     Operation::TAR2};
constexpr Operation kBoth[] = {Operation::EDGE_POSITIVE, Operation::EDGE_NEGATIVE};

Use useOf(Operation operation) {
  if (std::ranges::find(kWrites, operation) != std::end(kWrites)) return Use::Write;
  return std::ranges::find(kBoth, operation) != std::end(kBoth) ? Use::ReadWrite : Use::Read;
}

bool isCall(Operation operation) {
  return operation == Operation::UC || operation == Operation::CC;
}

}  // namespace

void Step7References::run() {
  const std::span<const std::uint8_t> code(block_.code);
  while (at_ < code.size()) {
    const auto decoded = mc7::decode(code.subspan(at_));
    std::size_t length = decoded ? decoded->length : 2;
    if (decoded) {
      const mc7::Instruction& one = decoded->instruction;
      instruction(one);
      if (isCall(one.operation))
        length += parameterList(one, code.subspan(std::min(at_ + length, code.size())));
    }
    at_ += length;
  }
}

void Step7References::beginStatement() {
  const Statement statement = statementAt(block_, offset());
  if (call_ && offset() >= call_->end) call_.reset();
  if (statement.begin == statement_) return;
  statement_ = statement.begin;
  bytes_.clear();
  call_ = callStatement(block_.code, offset(), statement.end, around_.options.mnemonics);
}

void Step7References::instruction(const mc7::Instruction& one) {
  const Operand& operand = one.operand;
  beginStatement();
  rows_.arrive(offset());
  opened_.arrived(offset());
  if (operand.kind == OperandKind::Memory) memory(one);
  if (operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter)
    add(operand, -1, useOf(one.operation), one);
  if (operand.kind == OperandKind::Block) add(operand, -1, Use::Call, one);
  if (operand.pointerArea != Area::None) pointer(one);
  if (isCall(one.operation)) instanceParameters(one);
  opened_.executed(one);
  bytes_.executed(one);
}

// L and V belong to the block; so do the instance that a CALL fills, and static data that a block
// without multiple instances addresses by DI.
void Step7References::memory(const mc7::Instruction& one) {
  Operand key = one.operand;
  std::int32_t db = -1;
  if (key.area == Area::DataBlock) {
    db = opened_.db();
  } else if (key.area == Area::Instance) {
    db = opened_.di();
    const bool filled = call_ && (db < 0 || db == call_->instance);
    if (filled || (db < 0 && block_.attributes.codeVersion1)) return;
    if (db >= 0) key.area = Area::DataBlock;
  } else if (key.area < Area::Peripheral || key.area > Area::Flag) {
    return;
  }
  add(key, db, useOf(one.operation), one);
}

// [MD 4], T [MW 4]: the pointer itself is read.
void Step7References::pointer(const mc7::Instruction& one) {
  const bool address = one.operand.kind == OperandKind::MemoryIndirect;
  mc7::Instruction read = one;
  read.operation = Operation::LOAD;
  read.operand = mc7::memory(one.operand.pointerArea, address ? Width::DWord : Width::Word,
                             bitAddress(one.operand.value));
  Operand key = read.operand;
  if (key.area == Area::Flag) return add(key, -1, Use::Read, one);
  if (key.area == Area::DataBlock) add(key, opened_.db(), Use::Read, one);
}

void Step7References::add(Operand key, std::int32_t db, Use use, const mc7::Instruction& one) {
  key.reg = 0;
  CrossReference row;
  row.key = mc7::placeOf(key);
  row.db = db;
  row.operand = mc7::operandText({use == Use::Write ? Operation::TRANSFER : Operation::LOAD, key},
                                 around_.options.mnemonics);
  if (key.kind == OperandKind::Block) {
    row.block = BlockId{key.blockKind, static_cast<std::uint16_t>(key.value)};
    row.operand = toString(*row.block);
    if (call_) row.instance = call_->instance;
  }
  if (db >= 0) row.operand = fmt::format("DB{}.{}", db, row.operand);
  add(std::move(row), use, one);
}

void Step7References::add(CrossReference row, Use use, const mc7::Instruction& one) {
  rows_.add(std::move(row), use, call_ ? call_->text : mc7::text(one, around_.options.mnemonics));
}

const block::Block* Step7References::called(const Operand& operand) const {
  const BlockId id{operand.blockKind, static_cast<std::uint16_t>(operand.value)};
  const auto own = around_.program.find(id);
  if (own != around_.program.end()) return &own->second;
  const block::Program* library = around_.options.library;
  if (library == nullptr) return nullptr;
  const auto system = library->find(id);
  return system == library->end() ? nullptr : &system->second;
}

}  // namespace merker::monitor
