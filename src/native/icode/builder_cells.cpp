// Timers and counters: nobody but the region itself changes them before it is left.
#include <vector>

#include "icode/builder.h"

namespace merker::icode {

Value Builder::timerRuns(const Cell& timer) {
  if (timer.isDirect())
    return append({.code = Opcode::TimerRuns, .number = timer.number, .place = atTheEnd()});
  return append({.code = Opcode::TimerRunsOf, .a = timer.value, .place = atTheEnd()});
}

Value Builder::timerUnits(std::uint32_t number) {
  return append({.code = Opcode::TimerUnits, .number = number, .place = atTheEnd()});
}

Value* Builder::known(Field field, const Cell& cell) {
  for (FieldValue& known : fields_)
    if (known.field == field && known.cell == cell) return &known.value;
  return nullptr;
}

// Two of which one is only known when the region runs can be the same.
void Builder::forgetOthers(Field field, const Cell& cell) {
  std::erase_if(fields_, [&](const FieldValue& known) {
    const bool differ = known.cell.isDirect() && cell.isDirect();
    return known.field == field && known.cell != cell && !differ;
  });
}

Value Builder::field(Field field, const Cell& cell) {
  if (const Value* value = known(field, cell)) return *value;
  Op op{.code = icode::isWord(field) ? Opcode::FieldWord : Opcode::FieldByte,
        .number = cell.number,
        .place = static_cast<std::uint32_t>(field)};
  if (!cell.isDirect()) {
    op.code = icode::isWord(field) ? Opcode::FieldWordOf : Opcode::FieldByteOf;
    op.a = cell.value;
  }
  const Value value = append(op);
  fields_.push_back({field, cell, value});
  return value;
}

void Builder::setField(Field field, const Cell& cell, Value value) {
  if (!icode::isNumber(field)) value = make(Opcode::ToWord, value);
  if (const Value* before = known(field, cell); before != nullptr && *before == value) return;
  Op op{.code = icode::isWord(field) ? Opcode::SetFieldWord : Opcode::SetFieldByte,
        .a = value,
        .number = cell.number,
        .place = static_cast<std::uint32_t>(field)};
  if (!cell.isDirect()) {
    op.code = icode::isWord(field) ? Opcode::SetFieldWordOf : Opcode::SetFieldByteOf;
    op.b = cell.value;
  }
  append(op);
  if (icode::isNumber(field))
    value = make(icode::isWord(field) ? Opcode::Zext16 : Opcode::Zext8, value);
  forgetOthers(field, cell);
  if (Value* const before = known(field, cell))
    *before = value;
  else
    fields_.push_back({field, cell, value});
}

}  // namespace merker::icode
