#include "step7/call_compiler.h"

#include <algorithm>

#include "base/text.h"

namespace merker::step7 {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

bool CallCompiler::compile(std::size_t begin) {
  CallParameters parameters(c_, target_);
  if (!target()) {
    parameters.skip();
    return false;
  }
  if (parameters.ofAnotherBlock()) {
    tellOtherBlock(c_.at(begin, c_.cursor().pos()));
    parameters.skip();
    return false;
  }
  auto actuals = parameters.read();
  if (!actuals) return false;
  actuals_ = std::move(*actuals);
  if (target_.isFunction())
    callFunction();
  else
    callFunctionBlock();
  return true;
}

// FC 5 and FC 6 are blocks of two libraries (docs/compatibility.md, "Libraries").
void CallCompiler::tellOtherBlock(const Position& place) {
  constexpr std::uint16_t kFirstOfBoth = 5, kLastOfBoth = 6;
  const BlockId id = target_.id;
  const bool ofBoth =
      id.kind == BlockKind::FC && kFirstOfBoth <= id.number && id.number <= kLastOfBoth;
  if (!ofBoth) return c_.problems().add(ProblemCode::P0506, place, toString(id));
  const bool cp = target_.block->attributes.family == "CP300";
  c_.problems().add(ProblemCode::P0525, place, toString(id), target_.block->symbol,
                    cp ? "SIMATIC_NET_CP" : "Standard Library");
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
  checkSystemBlock(begin);
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
  checkSystemBlock(begin);
  return target_.block != nullptr;
}

// A system block that the sources declare and the CPU does not have: those of an S7-400.
void CallCompiler::checkSystemBlock(std::size_t begin) {
  if (target_.id.kind != BlockKind::SFC && target_.id.kind != BlockKind::SFB) return;
  const block::Program* library = c_.scope().options->library;
  if (library == nullptr || !library->contains(target_.id))
    c_.problems().add(ProblemCode::P0508, c_.at(begin, c_.cursor().pos()), toString(target_.id));
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

void CallCompiler::read(const Access& from) {
  c_.access(from.operand.width == Width::Bit ? Operation::AND : Operation::LOAD, from);
}

void CallCompiler::write(const Access& to) {
  c_.access(to.operand.width == Width::Bit ? Operation::ASSIGN : Operation::TRANSFER, to);
}

// The code keeps the width of a constant and nothing else of its notation; a pointer stays one
// (code patterns, section 2).
void CallCompiler::constantTo(TypeCode type, const Operand& value, const Operand& to) {
  const unsigned bits = bitWidth(type);
  if (bits == 1) {
    put(value.value != 0 ? Operation::SET : Operation::CLR);
    return put(Operation::ASSIGN, to);
  }
  const std::uint32_t mask = bits >= 32 ? ~0u : (1u << bits) - 1;
  const ConstantFormat format = bits == 8    ? ConstantFormat::Byte
                                : bits == 16 ? ConstantFormat::Integer
                                : value.format == ConstantFormat::Pointer
                                    ? ConstantFormat::Pointer
                                    : ConstantFormat::LongInteger;
  put(Operation::LOAD, mc7::constant(format, value.value & mask));
  put(Operation::TRANSFER, to);
}

Operand CallCompiler::newPlace(Width width) {
  LocalData& data = c_.localData();
  if (width == Width::Bit) return mc7::memory(Area::Local, width, data.bit());
  return local(width, data.bytes(byteCount(width)));
}

}  // namespace merker::step7
