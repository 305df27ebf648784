// CALL of a function block: values into the instance, the call, values back (S7-FB-13, S7-PAR-03,
// S7-PAR-10; code patterns, section 3).
#include <algorithm>

#include "step7/call_compiler.h"
#include "step7/parameter_access.h"

namespace merker::step7 {

using block::Section;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

namespace {

// Composite values up to this size are moved by load and transfer, larger ones by SFC 20.
constexpr std::uint32_t kInlineBytes = 64;

bool isValue(const block::Variable& formal) {
  return isComposite(formal.type->code) && formal.section != Section::InOut;
}

bool isLarge(const block::Variable& formal) {
  return isValue(formal) && block::sizeInBytes(*formal.type) > kInlineBytes;
}

bool isRead(const block::Variable& formal) {
  return formal.section == Section::Input || formal.section == Section::InOut;
}

Width widestIn(std::uint32_t bytes) {
  return bytes >= 4 ? Width::DWord : bytes >= 2 ? Width::Word : Width::Byte;
}

// Of the data block that is open, without its number.
bool isInOpenBlock(const Actual& actual) {
  return actual.access && actual.access->kind == Access::Kind::Machine &&
         actual.access->operand.kind == OperandKind::Memory &&
         actual.access->operand.area == Area::DataBlock && actual.access->openDb < 0;
}

// The bracket marks: FB or SFB, with a data block or as a multiple instance.
std::uint32_t openingMark(const CallTarget& target) {
  const bool system = target.id.kind == BlockKind::SFB;
  if (target.instance) return system ? 16 : 14;
  return system ? 9 : 3;
}

}  // namespace

Operand CallCompiler::instanceOperand(BitAddress address, Width width) const {
  if (target_.instance)
    return mc7::registerIndirect(Area::Instance, width, 2, target_.instance->address + address);
  return mc7::memory(Area::Instance, width, address);
}

void CallCompiler::openInstance() {
  put(Operation::OPEN,
      target_.instance
          ? blockInWord(instanceNumber_.value / 8, true)
          : mc7::blockOperand(BlockKind::DB, static_cast<std::uint32_t>(target_.instanceDb), true));
}

// Saves AR2, the VKE and, for a multiple instance, the number of the own instance.
void CallCompiler::switchToInstance() {
  ar2_ = newPlace(Width::DWord);
  if (target_.instance) instanceNumber_ = newPlace(Width::Word);
  put(Operation::ASSIGN, newPlace(Width::Bit));
  if (target_.instance) {
    load(mc7::DataBlockQuery::DiNumber);
    put(Operation::TRANSFER, instanceNumber_);
  }
  copiesBefore();
  put(Operation::SWAP_DB);
  exchanged_ = true;
  openInstance();
  put(Operation::TAR2, ar2_);
}

// What cannot be reached while the registers are exchanged. STEP 7 has no such case in any block
// that is known (docs/compatibility.md).
void CallCompiler::copiesBefore() {
  const bool open = std::any_of(actuals_.begin(), actuals_.end(),
                                [](const auto& entry) { return isInOpenBlock(entry.second); });
  if (open) {
    openNumber_ = newPlace(Width::Word);
    load(mc7::DataBlockQuery::DbNumber);
    put(Operation::TRANSFER, openNumber_);
  }
  for (const block::Variable* formal : supplied()) {
    const Actual& actual = actuals_.at(formal);
    if (isLarge(*formal) && formal->section == Section::Input) copyBlock(*formal, actual, true);
    if (!isElementary(formal->type->code) || !isRead(*formal) || actual.isConstant() ||
        wayTo(*actual.access) != Way::Entry)
      continue;
    const Operand place = newPlace(widthOf(formal->type->code));
    read(*actual.access);
    write(machine(place));
    copiesOfEntries_[actual.access->variable] = place;
  }
}

void CallCompiler::passNumber(const block::Variable& formal, const Access& actual) {
  const Operand to = instanceOperand(formal.address, Width::Word);
  if (actual.kind == Access::Kind::Number) {  // own parameter of an FB
    put(Operation::LOAD,
        mc7::registerIndirect(Area::DataBlock, Width::Word, 2, actual.variable->address));
    return put(Operation::TRANSFER, to);
  }
  if (!actual.variable)
    return constantTo(TypeCode::Word, mc7::constant(ConstantFormat::Integer, actual.operand.value),
                      to);
  const Operand entry = newPlace(Width::DWord);  // of an FC: in the first word of its entry
  put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, actual.operand.value));
  put(Operation::TRANSFER, entry);
  put(Operation::LOAD, mc7::memory(Area::Local, Width::Word, entry.value));
  put(Operation::TRANSFER, to);
}

void CallCompiler::passIn(const block::Variable& formal, const Actual& actual) {
  const TypeCode code = formal.type->code;
  if (!isRead(formal) || isLarge(formal)) return;
  if (isParameterNumber(code)) return passNumber(formal, *actual.access);
  const bool any = code == TypeCode::Any;
  if (any || code == TypeCode::Pointer || (isComposite(code) && !isValue(formal)))
    return descriptor(actual, any, {true, formal.address / 8});
  if (actual.isConstant())
    return constantTo(code, actual.access->operand, instanceOperand(formal.address, widthOf(code)));
  if (isElementary(code))
    return valueIn(*actual.access, instanceOperand(formal.address, widthOf(code)));
  const std::uint32_t bytes = block::sizeInBytes(*formal.type);
  for (std::uint32_t byte = 0; byte < bytes;) {
    const Width width = widestIn(bytes - byte);
    valueIn(part(*actual.access, byte, width),
            instanceOperand(formal.address + bitAddress(byte), width));
    byte += byteCount(width);
  }
}

void CallCompiler::passOut(const block::Variable& formal, const Actual& actual) {
  const TypeCode code = formal.type->code;
  if (formal.section == Section::Input || !actual.access || isLarge(formal)) return;
  if (isElementary(code))
    return valueOut(instanceOperand(formal.address, widthOf(code)), *actual.access);
  if (!isValue(formal)) return;
  const std::uint32_t bytes = block::sizeInBytes(*formal.type);
  for (std::uint32_t byte = 0; byte < bytes;) {
    const Width width = widestIn(bytes - byte);
    valueOut(instanceOperand(formal.address + bitAddress(byte), width),
             part(*actual.access, byte, width));
    byte += byteCount(width);
  }
}

void CallCompiler::copiesAfterwards() {
  for (const CopyBack& copy : afterwards_) {
    read(machine(copy.from));
    write(copy.to);
  }
  for (const block::Variable* formal : supplied())
    if (isLarge(*formal) && formal->section == Section::Output)
      copyBlock(*formal, actuals_.at(formal), false);
}

void CallCompiler::callFunctionBlock() {
  const std::uint32_t opening = openingMark(target_);
  mark(opening);
  switchToInstance();
  for (const block::Variable* formal : supplied()) passIn(*formal, actuals_.at(formal));
  if (target_.instance)
    put(Operation::ADD_AR2, mc7::number(OperandKind::Pointer, target_.instance->address));
  else
    put(Operation::LAR2, mc7::constant(ConstantFormat::Pointer, pointer(Area::DataBlock, 0)));
  put(Operation::UC, mc7::blockOperand(target_.id.kind, target_.id.number));
  put(Operation::LAR2, ar2_);
  for (const block::Variable* formal : supplied()) passOut(*formal, actuals_.at(formal));
  put(Operation::SWAP_DB);
  exchanged_ = false;
  copiesAfterwards();
  mark(opening + 1);
}

// A large composite value between its variable and the instance, by SFC 20 BLKMOV.
void CallCompiler::copyBlock(const block::Variable& formal, const Actual& actual, bool in) {
  const BlockId id{BlockKind::SFC, 20};
  const block::Block* service = c_.scope().findBlock(id);
  if (!service) {
    c_.problems().add(ProblemCode::P0506, c_.at(actual.begin, actual.end), toString(id));
    return;
  }
  if (in && callerIsFunctionBlock()) put(Operation::TAR2, ar2_);  // the descriptors use AR2
  Actual inside;
  Access place;
  place.type = formal.type;
  place.operand = target_.instance ? instanceOperand(formal.address, Width::Byte)
                                   : mc7::memory(Area::DataBlock, Width::Byte, formal.address);
  place.openDb = target_.instance ? -1 : target_.instanceDb;
  inside.access = place;
  const Cells own = newCells(10), instance = newCells(10);
  descriptor(actual, true, own);
  descriptor(inside, true, instance);
  const Operand result = newPlace(Width::Word);
  std::vector<std::uint32_t> entries;
  for (const block::Variable* parameter : block::parameters(*service)) {
    const std::uint32_t byte = parameter->section == Section::Return          ? result.value / 8
                               : (parameter->section == Section::Input) == in ? own.byte
                                                                              : instance.byte;
    entries.push_back(pointer(Area::CallerLocal, bitAddress(byte)));
  }
  callWithList(entries, id);
}

}  // namespace merker::step7
