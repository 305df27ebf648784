// Names of the block that is compiled: parameters, static and temporary data (S7-IND-09,
// S7-PAR-03).
#include "step7/operand_parser.h"

namespace merker::step7 {

using mc7::OperandKind;

std::optional<Access> OperandParser::local(std::string_view name, std::size_t begin) {
  if (const block::Variable* variable = scope_.findVariable(name))
    return localVariable(*variable, begin);
  if (isOwnName(name))
    if (const block::Variable* result = scope_.findVariable("RET_VAL"))
      return localVariable(*result, begin);
  if (isGlobalSymbol(name)) return unquoted(name, begin);
  return problem(ProblemCode::P0313, begin, std::string(name),
                 scope_.block ? toString(scope_.block->id) : std::string("the block"));
}

std::optional<Access> OperandParser::localVariable(const block::Variable& variable,
                                                   std::size_t begin) {
  Access access;
  access.variable = &variable;
  Place place{variable.type, variable.address};
  const bool function =
      scope_.block->id.kind == BlockKind::FC || scope_.block->id.kind == BlockKind::SFC;
  if (isParameterNumber(variable.type->code)) return numberParameter(variable, access);
  if (!followPath(cursor_, place, *scope_.file, problems_, scope_.members())) return std::nullopt;
  if (variable.section == block::Section::Temp) return placed(access, Area::Local, place, 0);
  if (function) return parameterOfFunction(variable, access, place);
  if (scope_.block->id.kind == BlockKind::FB) return instanceVariable(variable, access, place);
  return problem(ProblemCode::P0313, begin, variable.name, toString(scope_.block->id));
}

std::optional<Access> OperandParser::placed(Access access, Area area, const Place& place, int reg) {
  access.type = place.type;
  const Width width = widthOf(place.type->code);
  access.operand = reg ? mc7::registerIndirect(area, width, reg, place.address)
                       : mc7::memory(area, width, place.address);
  return access;
}

// S7-SYM-05: STEP 7 takes a symbol without quotation marks, behind # or not, where no local
// variable has the name.
bool OperandParser::isGlobalSymbol(std::string_view name) const {
  const source::SymbolTable* symbols = scope_.options->symbols;
  return scope_.block && symbols && symbols->find(std::string(name));
}

// #"Scale" in the function "Scale": its return value, as the TIA Portal writes it.
bool OperandParser::isOwnName(std::string_view name) const {
  if (!isGlobalSymbol(name) || scope_.block->id.kind != BlockKind::FC) return false;
  const source::SymbolAddress& address = scope_.options->symbols->find(std::string(name))->address;
  return address.kind == source::SymbolAddress::Kind::Block && address.block == scope_.block->id;
}

std::optional<Access> OperandParser::unquoted(std::string_view name, std::size_t begin) {
  problem(ProblemCode::P0354, begin, name);
  return symbol(std::string(name), begin);
}

std::optional<Access> OperandParser::parameterOfFunction(const block::Variable& variable,
                                                         Access access, Place place) {
  access.type = place.type;
  if (isComposite(variable.type->code)) {
    access.kind = Access::Kind::Descriptor;
    access.descriptor = &variable;
    access.operand =
        mc7::registerCrossing(widthOf(place.type->code), 1, place.address - variable.address);
    return access;
  }
  access.operand = {.kind = OperandKind::Parameter,
                    .width = widthOf(variable.type->code),
                    .value = scope_.names->parameterIndex(variable)};
  return access;
}

std::optional<Access> OperandParser::instanceVariable(const block::Variable& variable,
                                                      Access access, Place place) {
  if (variable.section == block::Section::InOut && isComposite(variable.type->code)) {
    access.type = place.type;
    access.kind = Access::Kind::Descriptor;
    access.descriptor = &variable;
    access.operand =
        mc7::registerCrossing(widthOf(place.type->code), 1, place.address - variable.address);
    return access;
  }
  if (place.address > 0xFFFF) return problem(ProblemCode::P0504, begin_, place.address / 8);
  return placed(access, Area::Instance, place, 2);
}

// TIMER, COUNTER, BLOCK_*: an FC finds the number in its parameter list, an FB in its instance.
std::optional<Access> OperandParser::numberParameter(const block::Variable& variable,
                                                     Access access) {
  access.type = variable.type;
  const TypeCode code = variable.type->code;
  const bool timer = code == TypeCode::Timer, counter = code == TypeCode::Counter;
  const BlockKind kind = code == TypeCode::BlockFc   ? BlockKind::FC
                         : code == TypeCode::BlockFb ? BlockKind::FB
                         : code == TypeCode::BlockDb ? BlockKind::DB
                                                     : BlockKind::SDB;
  mc7::Operand& operand = access.operand;
  if (!timer && !counter) operand.blockKind = kind;
  if (scope_.block->id.kind == BlockKind::FB) {
    access.kind = Access::Kind::Number;
    operand.kind = timer     ? OperandKind::TimerIndirect
                   : counter ? OperandKind::CounterIndirect
                             : OperandKind::BlockIndirect;
    operand.pointerArea = Area::Local;
  } else {
    operand.kind = timer     ? OperandKind::TimerParameter
                   : counter ? OperandKind::CounterParameter
                             : OperandKind::BlockParameter;
    operand.value = scope_.names->parameterIndex(variable);
  }
  return access;
}

// P##name (S7-IND-09).
std::optional<Access> OperandParser::addressOf(std::size_t begin) {
  cursor_.seek(cursor_.pos() + 3);
  cursor_.skipBlanks();
  const std::size_t nameBegin = cursor_.pos();
  const std::string_view name = cursor_.word();
  const block::Variable* variable = scope_.findVariable(name);
  if (!variable)
    return problem(ProblemCode::P0313, nameBegin, std::string(name),
                   scope_.block ? toString(scope_.block->id) : std::string("the block"));
  Access access;
  access.kind = Access::Kind::Address;
  access.variable = variable;
  const bool function = scope_.block->id.kind == BlockKind::FC;
  if (function && variable->section != block::Section::Temp) {
    access.operand =
        mc7::number(OperandKind::ParameterAddress, scope_.names->parameterIndex(*variable));
    return access;
  }
  Place place{variable->type, variable->address};
  if (!followPath(cursor_, place, *scope_.file, problems_, scope_.members())) return std::nullopt;
  const Area area = variable->section == block::Section::Temp ? Area::Local : Area::Instance;
  access.type = place.type;
  access.operand = mc7::constant(ConstantFormat::Pointer, pointer(area, place.address));
  (void)begin;
  return access;
}

}  // namespace merker::step7
