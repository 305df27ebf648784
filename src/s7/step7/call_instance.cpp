// CALL of a function block: values into the instance, the call, values back (S7-FB-13, S7-PAR-03,
// S7-PAR-10).
#include <algorithm>

#include "step7/call_compiler.h"

namespace merker::step7 {

using block::Section;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

namespace {

// Composite values up to this size are moved by load and transfer, larger ones by SFC 20.
constexpr std::uint32_t kInlineBytes = 64;

}  // namespace

Operand CallCompiler::instanceOperand(BitAddress address, Width width) const {
  if (target_.instance)
    return mc7::registerIndirect(Area::Instance, width, 2, target_.instance->address + address);
  return mc7::memory(Area::Instance, width, address);
}

void CallCompiler::collectBytes(BitAddress instance, const Operand& from, std::uint32_t bytes) {
  std::uint32_t byte = 0;
  while (byte < bytes) {
    const Width width = bytes - byte >= 4   ? Width::DWord
                        : bytes - byte >= 2 ? Width::Word
                                            : Width::Byte;
    const TypeCode type = width == Width::DWord  ? TypeCode::DWord
                          : width == Width::Word ? TypeCode::Word
                                                 : TypeCode::Byte;
    transfers_.push_back({instance + byte * 8, local(width, from.value / 8 + byte), type});
    byte += byteCount(width);
  }
}

void CallCompiler::collectComposite(const block::Variable& formal, const Actual& actual) {
  if (formal.section == Section::InOut)
    return collectBytes(formal.address, local(Width::Byte, descriptor(actual, false)), 6);
  const std::uint32_t bytes = block::sizeInBytes(*formal.type);
  if (formal.section != Section::Input) return;
  if (bytes > kInlineBytes) return copyBlock(formal, actual, true);
  const std::uint32_t place = c_.allocate(bytes);
  for (std::uint32_t byte = 0; byte < bytes; byte += 2)
    move(Width::Word, part(*actual.access, byte, Width::Word),
         machine(local(Width::Word, place + byte)));
  collectBytes(formal.address, local(Width::Byte, place), bytes);
}

void CallCompiler::collectInput(const block::Variable& formal, const Actual& actual) {
  const TypeCode code = formal.type->code;
  if (isParameterNumber(code)) {
    const Access& access = *actual.access;
    if (!access.variable) {
      transfers_.push_back({formal.address,
                            mc7::constant(ConstantFormat::Word, access.operand.value),
                            TypeCode::Word});
    } else if (access.operand.pointerArea == Area::Local) {  // own parameter of an FB
      transfers_.push_back(
          {formal.address, local(Width::Word, c_.parameterCopy(*access.variable)), TypeCode::Word});
    } else {  // of an FC: the number stands in the first word of its entry
      const std::uint32_t byte = c_.allocate(4);
      put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, access.operand.value));
      put(Operation::TRANSFER, local(Width::DWord, byte));
      transfers_.push_back({formal.address, local(Width::Word, byte), TypeCode::Word});
    }
    return;
  }
  if (code == TypeCode::Any || code == TypeCode::Pointer) {
    const std::uint32_t byte = descriptor(actual, code == TypeCode::Any);
    return collectBytes(formal.address, local(Width::Byte, byte), code == TypeCode::Any ? 10 : 6);
  }
  if (!isElementary(code)) return collectComposite(formal, actual);
  if (formal.section == Section::Output) return;
  const Access& access = *actual.access;
  const bool direct = actual.isConstant() || needsNoDataBlock(access);
  transfers_.push_back(
      {formal.address, direct ? access.operand : staged(access, widthOf(code), true, false), code});
}

void CallCompiler::collectOutputs() {
  for (const block::Variable* formal : supplied()) {
    const Actual& actual = actuals_.at(formal);
    if (formal->section == Section::Input || !actual.access) continue;
    const Access& to = *actual.access;
    const TypeCode code = formal->type->code;
    if (isElementary(code)) {
      const Width width = widthOf(code);
      const Operand from = instanceOperand(formal->address, width);
      if (needsNoDataBlock(to)) {
        fromInstance_.push_back({from, to});
      } else {
        const Operand place = local(width, c_.allocate(byteCount(width)));
        fromInstance_.push_back({from, machine(place)});
        afterwards_.push_back({place, to});
      }
    } else if (formal->section == Section::Output && isComposite(code)) {
      const std::uint32_t bytes = block::sizeInBytes(*formal->type);
      if (bytes > kInlineBytes) continue;
      const std::uint32_t place = c_.allocate(bytes);
      for (std::uint32_t byte = 0; byte < bytes; byte += 2) {
        const Operand word = local(Width::Word, place + byte);
        fromInstance_.push_back(
            {instanceOperand(formal->address + byte * 8, Width::Word), machine(word)});
        afterwards_.push_back({word, part(to, byte, Width::Word)});
      }
    }
  }
}

void CallCompiler::transferIn(const Transfer& transfer) {
  const Width width = widthOf(transfer.type);
  const Operand to = instanceOperand(transfer.address, width);
  if (transfer.from.kind == OperandKind::Constant)
    storeConstant(transfer.type, transfer.from.value, to);
  else
    move(width, machine(transfer.from), machine(to));
}

void CallCompiler::switchToInstance() {
  if (target_.instance) return;
  put(Operation::SWAP_DB);
  put(Operation::OPEN,
      mc7::blockOperand(BlockKind::DB, static_cast<std::uint32_t>(target_.instanceDb), true));
}

void CallCompiler::switchBack() {
  if (!target_.instance) put(Operation::SWAP_DB);
}

void CallCompiler::callFunctionBlock() {
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 3));
  keeps_ = touchesResult();
  if (keeps_) result_ = c_.allocate(1);
  ar2_ = c_.allocate(4);
  keepResult();
  for (const block::Variable* formal : supplied()) collectInput(*formal, actuals_.at(formal));
  collectOutputs();
  switchToInstance();
  for (const Transfer& transfer : transfers_) transferIn(transfer);
  put(Operation::TAR2, local(Width::DWord, ar2_));
  if (!target_.instance)
    put(Operation::LAR2, mc7::constant(ConstantFormat::Pointer, pointer(Area::DataBlock, 0)));
  else if (target_.instance->address)
    put(Operation::ADD_AR2, mc7::number(OperandKind::Pointer, target_.instance->address));
  returnResult();
  put(Operation::UC, mc7::blockOperand(target_.id.kind, target_.id.number));
  put(Operation::LAR2, local(Width::DWord, ar2_));
  keepResult();
  for (const CopyBack& copy : fromInstance_) move(copy.from.width, machine(copy.from), copy.to);
  switchBack();
  for (const CopyBack& copy : afterwards_) move(copy.from.width, machine(copy.from), copy.to);
  for (const auto& [formal, actual] : actuals_)
    if (formal->section == Section::Output && isComposite(formal->type->code) &&
        block::sizeInBytes(*formal->type) > kInlineBytes)
      copyBlock(*formal, actual, false);
  returnResult();
  if (keeps_) put(Operation::SPBI, mc7::number(OperandKind::Jump, 2));
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 4));
}

// A large composite value between its variable and the instance, by SFC 20 BLKMOV.
void CallCompiler::copyBlock(const block::Variable& formal, const Actual& actual, bool in) {
  const block::Block* service = c_.scope().findBlock({BlockKind::SFC, 20});
  if (!service) {
    c_.problems().add(ProblemCode::P0506, c_.at(actual.begin, actual.end),
                      toString(BlockId{BlockKind::SFC, 20}));
    return;
  }
  Actual inside;
  Access place;
  place.type = formal.type;
  place.operand = target_.instance ? instanceOperand(formal.address, Width::Byte)
                                   : mc7::memory(Area::DataBlock, Width::Byte, formal.address);
  place.openDb = target_.instance ? -1 : target_.instanceDb;
  inside.access = place;
  const std::uint32_t own = descriptor(actual, true), instance = descriptor(inside, true);
  const std::uint32_t result = c_.allocate(2);
  const auto parameters = block::parameters(*service);
  put(Operation::UC, mc7::blockOperand(BlockKind::SFC, 20));
  put(Operation::SPA,
      mc7::number(OperandKind::Jump, static_cast<std::uint32_t>(2 * parameters.size() + 2)));
  for (const block::Variable* parameter : parameters) {
    const std::uint32_t byte = parameter->section == Section::Return          ? result
                               : (parameter->section == Section::Input) == in ? own
                                                                              : instance;
    c_.builder().parameterEntry(pointer(Area::CallerLocal, byte * 8));
  }
}

}  // namespace merker::step7
