// CALL of a function: values that the parameter list cannot name are staged in local data (code
// patterns, section 2).
#include <algorithm>

#include "step7/call_compiler.h"

namespace merker::step7 {

using block::Section;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

namespace {

// What an entry of the list can name: a place whose area is fixed. DBX and DIX are those of the
// blocks that are open at the call.
bool hasPointer(const Access& access) {
  return access.kind == Access::Kind::Machine && access.operand.kind == OperandKind::Memory &&
         access.openDb < 0;
}

std::uint32_t entryOf(const Operand& place) {
  return pointer(place.area == Area::Local ? Area::CallerLocal : place.area, place.value);
}

}  // namespace

std::uint32_t CallCompiler::elementaryEntry(const block::Variable& formal, const Actual& actual) {
  const Access& access = *actual.access;
  if (!actual.isConstant() && hasPointer(access)) return entryOf(access.operand);
  const TypeCode type = formal.type->code;
  const Operand place = newPlace(widthOf(type));
  if (actual.isConstant()) {
    constantTo(type, access.operand, place);
    return entryOf(place);
  }
  if (formal.section == Section::Input || formal.section == Section::InOut) {
    read(access);
    write(machine(place));
  }
  if (formal.section != Section::Input) afterwards_.push_back({place, access});
  return entryOf(place);
}

// The entry of the parameter list behind the call (MC7 section 7.2).
std::uint32_t CallCompiler::entry(const block::Variable& formal, const Actual& actual) {
  const TypeCode code = formal.type->code;
  if (isElementary(code)) return elementaryEntry(formal, actual);
  if (isParameterNumber(code)) return actual.access->operand.value << 16;
  const bool any = code == TypeCode::Any;
  if (isDescriptor(actual, any) && actual.access->variable->section == Section::Temp)
    return pointer(Area::CallerLocal, actual.access->operand.value);
  const Cells cells = newCells(any ? 10 : 6);
  descriptor(actual, any, cells);
  return pointer(Area::CallerLocal, bitAddress(cells.byte));
}

void CallCompiler::callWithList(const std::vector<std::uint32_t>& entries, BlockId id) {
  put(Operation::UC, mc7::blockOperand(id.kind, id.number));
  put(Operation::SPA,
      mc7::number(OperandKind::Jump, static_cast<std::uint32_t>(2 * entries.size() + 2)));
  for (const std::uint32_t value : entries) c_.builder().parameterEntry(value);
}

bool CallCompiler::savesAr2() const {
  const block::Block& caller = *c_.scope().block;
  const bool data = std::ranges::any_of(
      caller.variables, [](const auto& v) { return v.section != block::Section::Temp; });
  return callerIsFunctionBlock() && (data || !caller.attributes.codeVersion1);
}

void CallCompiler::callFunction() {
  const std::uint32_t opening = target_.id.kind == BlockKind::SFC ? 7 : 1;
  mark(opening);
  if (savesAr2()) ar2_ = newPlace(Width::DWord);
  // The VKE; the old version of the code does not keep it.
  if (!c_.scope().block->attributes.codeVersion1) put(Operation::ASSIGN, newPlace(Width::Bit));
  if (savesAr2()) put(Operation::TAR2, ar2_);
  std::vector<std::uint32_t> entries;
  for (const block::Variable* formal : c_.scope().interfaces->names(*target_.block).parameters())
    entries.push_back(entry(*formal, actuals_.at(formal)));
  callWithList(entries, target_.id);
  if (savesAr2()) put(Operation::LAR2, ar2_);
  for (const CopyBack& copy : afterwards_) {
    read(machine(copy.from));
    write(copy.to);
  }
  mark(opening + 1);
}

}  // namespace merker::step7
