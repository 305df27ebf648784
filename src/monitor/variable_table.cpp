#include "monitor/variable_table.h"

#include "cpu/memory_access.h"

namespace merker::monitor {
namespace {

Position nowhere() { return Position{"", 0, 0, 0}; }

bool comesBy(std::optional<Trigger>& trigger, cpu::CyclePoint point) {
  if (!trigger || trigger->point != point) return false;
  if (trigger->once) trigger.reset();
  return true;
}

// Inputs: their process image, which this cycle works with; the terminals stay.
void modifyInCycle(station::Station& station, const VariableRow& row) {
  const mc7::Operand& operand = row.operand.operand;
  const bool input = operand.kind == mc7::OperandKind::Memory && operand.area == Area::Input;
  if (input)
    cpu::write(station.cpu().machine(), Area::Input, operand.width, operand.value, *row.modify);
  else
    station.write(row.operand, *row.modify);
}

}  // namespace

std::optional<Problem> VariableTable::add(std::string_view operand, DisplayFormat format) {
  auto reference = resolver_(operand, nowhere());
  if (!reference) return reference.error();
  if (reference->operand.kind != mc7::OperandKind::Memory && format != DisplayFormat::Bool)
    reference->operand.width = Width::Word;
  rows_.push_back({std::move(*reference), DisplayFormat::Automatic, {}, {}});
  const auto problem = setFormat(rows_.size() - 1, format);
  if (problem) rows_.pop_back();
  return problem;
}

std::optional<Problem> VariableTable::setFormat(std::size_t row, DisplayFormat format) {
  const unsigned bits = simulator::bitWidth(rows_[row].operand);
  const bool status =
      format == DisplayFormat::Bool && rows_[row].operand.operand.kind != mc7::OperandKind::Memory;
  if (!fits(format, bits) && !status)
    return makeProblem(ProblemCode::P1209, nowhere(), rows_[row].operand.text, name(format),
                       bitsText(format));
  rows_[row].format = format;
  return std::nullopt;
}

std::optional<Problem> VariableTable::setModify(std::size_t row, std::string_view value) {
  rows_[row].modify.reset();
  if (value.empty()) return std::nullopt;
  const auto bits = parseValue(rows_[row].operand, value, rows_[row].format);
  if (!bits) return bits.error();
  rows_[row].modify = *bits;
  return std::nullopt;
}

std::string VariableTable::text(std::size_t row) const {
  const VariableRow& one = rows_[row];
  return one.status ? show(one.operand, *one.status, one.format) : "?";
}

void VariableTable::monitorNow() {
  for (VariableRow& row : rows_) row.status = station_.read(row.operand);
}

void VariableTable::modifyNow() {
  for (const VariableRow& row : rows_)
    if (row.modify) station_.write(row.operand, *row.modify);
}

void VariableTable::reached(cpu::CyclePoint point) {
  if (comesBy(modify_, point))
    for (const VariableRow& row : rows_)
      if (row.modify) modifyInCycle(station_, row);
  if (comesBy(monitor_, point)) monitorNow();
}

}  // namespace merker::monitor
