#include "step7/call_compiler.h"

#include <algorithm>
#include <bit>

#include "base/text.h"
#include "step7/initial_value.h"

namespace merker::step7 {

using block::Section;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

bool CallCompiler::needsNoDataBlock(const Access& access) {
  const Operand& operand = access.operand;
  return access.kind == Access::Kind::Machine && operand.kind == OperandKind::Memory &&
         access.openDb < 0 && operand.area != Area::DataBlock && operand.area != Area::Instance;
}

bool CallCompiler::compile(std::size_t begin) {
  CallParameters parameters(c_, target_);
  if (!target()) {
    parameters.skip();
    return false;
  }
  auto actuals = parameters.read();
  if (!actuals) return false;
  actuals_ = std::move(*actuals);
  (void)begin;
  if (target_.isFunction())
    callFunction();
  else
    callFunctionBlock();
  return true;
}

bool CallCompiler::target() {
  Cursor& cursor = c_.cursor();
  cursor.skipSpace();
  const std::size_t begin = cursor.pos();
  if (cursor.accept('#') || !cursor.peekWord("FC")) {
    const std::string_view name = cursor.word();
    if (const block::Variable* variable = c_.scope().findVariable(name);
        variable && isComposite(variable->type->code))
      return instanceTarget(*variable, begin);
    cursor.seek(begin);
  }
  const auto access = c_.operand();
  if (!access) return false;
  const auto place = c_.at(begin, cursor.pos());
  const BlockKind kind = access->operand.blockKind;
  if (access->kind != Access::Kind::BlockName || kind == BlockKind::DB || kind == BlockKind::UDT) {
    c_.problems().add(ProblemCode::P0518, place);
    return false;
  }
  if (kind == BlockKind::OB) {  // S7-BLK-17
    c_.problems().add(ProblemCode::P0510, place);
    return false;
  }
  target_.id = {kind, static_cast<std::uint16_t>(access->operand.value)};
  target_.block = c_.scope().findBlock(target_.id);
  if (!target_.block) {
    c_.problems().add(ProblemCode::P0506, place, toString(target_.id));
    return false;
  }
  return target_.isFunction() || instanceDataBlock(begin);
}

bool CallCompiler::instanceTarget(const block::Variable& variable, std::size_t begin) {
  const TypeCode code = variable.type->code;
  const bool instance = code == TypeCode::FunctionBlock || code == TypeCode::SystemFunctionBlock;
  if (!instance) {
    c_.problems().add(ProblemCode::P0518, c_.at(begin, c_.cursor().pos()));
    return false;
  }
  target_.id = {code == TypeCode::FunctionBlock ? BlockKind::FB : BlockKind::SFB,
                variable.type->length};
  target_.block = c_.scope().findBlock(target_.id);
  target_.instance = &variable;
  return target_.block != nullptr;
}

// CALL FB 1, DB 2: the data block must be an instance of this FB (S7-FB-05, S7-FB-07, S7-PAR-11).
bool CallCompiler::instanceDataBlock(std::size_t begin) {
  Cursor& cursor = c_.cursor();
  if (!cursor.accept(',')) {
    c_.problems().add(ProblemCode::P0519, c_.at(begin, cursor.pos()), toString(target_.id));
    return false;
  }
  cursor.skipSpace();
  const std::size_t dbBegin = cursor.pos();
  const auto access = c_.operand();
  if (!access) return false;
  const auto place = c_.at(dbBegin, cursor.pos());
  if (access->kind != Access::Kind::BlockName || access->operand.blockKind != BlockKind::DB ||
      access->operand.value == 0) {
    c_.problems().add(ProblemCode::P0519, place, toString(target_.id));
    return false;
  }
  const BlockId id{BlockKind::DB, static_cast<std::uint16_t>(access->operand.value)};
  const block::Block* db = c_.scope().findBlock(id);
  if (!db) {
    c_.problems().add(ProblemCode::P0520, place, toString(id), toString(target_.id));
    return false;
  }
  if (c_.scope().interfaces->unknown(id)) {
    c_.problems().add(ProblemCode::P0430, place, toString(id));
    return false;
  }
  if (db->instanceOf != target_.id.number ||
      db->instanceOfSystemBlock != (target_.id.kind == BlockKind::SFB)) {
    c_.problems().add(ProblemCode::P0521, place, toString(id), toString(target_.id));
    return false;
  }
  target_.instanceDb = id.number;
  return true;
}

std::vector<const block::Variable*> CallCompiler::supplied() const {
  const BlockNames& names = c_.scope().interfaces->names(*target_.block);
  std::vector<const block::Variable*> formals;
  for (const auto& [formal, actual] : actuals_) formals.push_back(formal);
  std::sort(formals.begin(), formals.end(), [&](const auto* a, const auto* b) {
    return names.parameterIndex(*a) < names.parameterIndex(*b);
  });
  return formals;
}

// --- building blocks

Access CallCompiler::machine(const Operand& operand) {
  Access access;
  access.operand = operand;
  return access;
}

// `byte` bytes behind the beginning of `access`, with another width.
Access CallCompiler::part(const Access& access, std::uint32_t byte, Width width) {
  Access result = access;
  result.operand.value += byte * 8;
  result.operand.width = width;
  return result;
}

void CallCompiler::move(Width width, const Access& from, const Access& to) {
  c_.access(width == Width::Bit ? Operation::AND : Operation::LOAD, from);
  c_.access(width == Width::Bit ? Operation::ASSIGN : Operation::TRANSFER, to);
}

void CallCompiler::loadConstant(Width width, std::uint32_t value) {
  put(Operation::LOAD, width == Width::Byte   ? mc7::constant(ConstantFormat::Byte, value & 0xFF)
                       : width == Width::Word ? mc7::constant(ConstantFormat::Word, value & 0xFFFF)
                                              : mc7::constant(ConstantFormat::DWord, value));
}

// The notation in which a disassembler shows a value of this type.
static ConstantFormat notationOf(TypeCode type) {
  switch (type) {
    case TypeCode::Byte:
      return ConstantFormat::Byte;
    case TypeCode::Char:
      return ConstantFormat::Characters;
    case TypeCode::Int:
      return ConstantFormat::Integer;
    case TypeCode::DInt:
      return ConstantFormat::LongInteger;
    case TypeCode::Real:
      return ConstantFormat::Real;
    case TypeCode::Date:
      return ConstantFormat::Date;
    case TypeCode::TimeOfDay:
      return ConstantFormat::TimeOfDay;
    case TypeCode::Time:
      return ConstantFormat::Time;
    case TypeCode::S5Time:
      return ConstantFormat::S5Time;
    default:
      return bitWidth(type) > 16 ? ConstantFormat::DWord : ConstantFormat::Word;
  }
}

void CallCompiler::storeConstant(TypeCode type, std::uint32_t bits, const Operand& to) {
  if (type == TypeCode::Bool) {
    put(bits ? Operation::SET : Operation::CLR);
    put(Operation::ASSIGN, to);
    return;
  }
  const std::uint32_t mask = bitWidth(type) >= 32 ? ~0u : (1u << bitWidth(type)) - 1;
  put(Operation::LOAD, mc7::constant(notationOf(type), bits & mask));
  put(Operation::TRANSFER, to);
}

Operand CallCompiler::constantInLocal(TypeCode type, std::uint32_t bits) {
  const Width width = widthOf(type);
  const Operand place = local(width, c_.allocate(byteCount(width)));
  storeConstant(type, bits, place);
  return place;
}

// A copy in local data of a value that the called block cannot reach by itself.
Operand CallCompiler::staged(const Access& access, Width width, bool copyIn, bool copyOut) {
  const Operand place = local(width, c_.allocate(byteCount(width)));
  if (copyIn) move(width, access, machine(place));
  if (copyOut) afterwards_.push_back({place, access});
  return place;
}

// Copies of BOOL values go through the VKE; the called block and the caller find theirs unchanged.
bool CallCompiler::touchesResult() const {
  return std::any_of(actuals_.begin(), actuals_.end(), [this](const auto& entry) {
    const auto& [formal, actual] = entry;
    if (formal->type->code != TypeCode::Bool || !actual.access) return false;
    return !target_.isFunction() || !needsNoDataBlock(*actual.access);
  });
}

void CallCompiler::keepResult() {
  if (keeps_) put(Operation::ASSIGN, local(Width::Bit, result_));
}

void CallCompiler::returnResult() {
  if (keeps_) put(Operation::AND, local(Width::Bit, result_));
}

// --- functions

std::uint32_t CallCompiler::elementaryEntry(const block::Variable& formal, const Actual& actual) {
  const Access& access = *actual.access;
  const TypeCode type = formal.type->code;
  Operand place = access.operand;
  if (actual.isConstant())
    place = constantInLocal(type, access.operand.value);
  else if (!needsNoDataBlock(access))
    place = staged(access, widthOf(type),
                   formal.section == Section::Input || formal.section == Section::InOut,
                   formal.section != Section::Input);
  const Area area = place.area == Area::Local ? Area::CallerLocal : place.area;
  return pointer(area, place.value);
}

// The entry of the parameter list behind the call (MC7 section 7.2).
std::uint32_t CallCompiler::entry(const block::Variable& formal, const Actual& actual) {
  const TypeCode code = formal.type->code;
  if (isElementary(code)) return elementaryEntry(formal, actual);
  if (isParameterNumber(code)) return actual.access->operand.value << 16;
  return pointer(Area::CallerLocal, descriptor(actual, code == TypeCode::Any) * 8);
}

void CallCompiler::callFunction() {
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 1));
  keeps_ = touchesResult();
  if (keeps_) result_ = c_.allocate(1);
  keepResult();
  std::vector<std::uint32_t> entries;
  for (const block::Variable* formal : c_.scope().interfaces->names(*target_.block).parameters())
    entries.push_back(entry(*formal, actuals_.at(formal)));
  returnResult();
  put(Operation::UC, mc7::blockOperand(target_.id.kind, target_.id.number));
  put(Operation::SPA,
      mc7::number(OperandKind::Jump, static_cast<std::uint32_t>(2 * entries.size() + 2)));
  for (const std::uint32_t value : entries) c_.builder().parameterEntry(value);
  if (!afterwards_.empty()) {
    keepResult();
    for (const CopyBack& copy : afterwards_) move(copy.from.width, machine(copy.from), copy.to);
    returnResult();
    // A jump to the next instruction ends the chain as the call did: /ER 0, STA 1 (S7-INSTR-105).
    if (keeps_) put(Operation::SPBI, mc7::number(OperandKind::Jump, 2));
  }
  put(Operation::BLD, mc7::number(OperandKind::ShiftCount, 2));
}

}  // namespace merker::step7
