#include "monitor/variable_table.h"

#include "monitor/nowhere.h"

namespace merker::monitor {
namespace {

bool comesBy(std::optional<Trigger>& trigger, CyclePoint point) {
  if (!trigger || trigger->point != point) return false;
  if (trigger->once) trigger.reset();
  return true;
}

}  // namespace

std::optional<Problem> VariableTable::add(std::string_view operand, DisplayFormat format) {
  auto reference = resolver_(operand, nowhere());
  if (!reference) return reference.error();
  if (reference->operand.kind != address::OperandKind::Memory && format != DisplayFormat::Bool)
    reference->operand.width = Width::Word;
  rows_.push_back({std::move(*reference), DisplayFormat::Automatic, {}, {}});
  const auto problem = setFormat(rows_.size() - 1, format);
  if (problem) rows_.pop_back();
  return problem;
}

std::optional<Problem> VariableTable::setFormat(std::size_t row, DisplayFormat format) {
  auto problem = checkFormat(rows_[row].operand, format);
  if (!problem) rows_[row].format = format;
  return problem;
}

std::optional<Problem> VariableTable::setModify(std::size_t row, std::string_view value) {
  rows_[row].modify.reset();
  if (value.empty()) return std::nullopt;
  auto parsed = parse(rows_[row].operand, value, rows_[row].format, resolver_.constants);
  if (!parsed) return parsed.error();
  if (auto problem = access_.checkValue(rows_[row].operand, *parsed)) return problem;
  rows_[row].modify = std::move(parsed.value());
  return std::nullopt;
}

std::string VariableTable::text(std::size_t row) const {
  const VariableRow& one = rows_[row];
  return one.status ? show(one.operand, *one.status, one.format) : "?";
}

void VariableTable::monitorNow() {
  for (VariableRow& row : rows_) {
    const bool local = row.operand.text.starts_with('#');
    const auto now = local ? resolver_(row.operand.text, nowhere()) : row.operand;
    row.status = now ? read(access_.machine(), *now) : std::nullopt;
  }
}

void VariableTable::modifyNow() {
  for (const VariableRow& row : rows_)
    if (row.modify && !access_.checkWrite(row.operand))
      write(access_.machine(), row.operand, *row.modify);
}

void VariableTable::reached(CyclePoint point) {
  if (comesBy(modify_, point))
    for (const VariableRow& row : rows_)
      if (row.modify) access_.modifyInCycle(row.operand, *row.modify);
  if (comesBy(monitor_, point)) monitorNow();
}

}  // namespace merker::monitor
