#include "workbench/watch_list.h"

#include <bit>
#include <cmath>

#include "mc5/s5_float.h"
#include "scenario/long_value.h"
#include "workbench/operand_name.h"

namespace merker::workbench {

Json rawValue(const address::Reference& reference, const monitor::Value& value,
              monitor::DisplayFormat format) {
  if (reference.nc != 0) return std::stod(value.content);
  if (simulator::isLong(reference)) return nullptr;
  if (format == monitor::DisplayFormat::Kg) return mc5::toDouble(value.bits);
  if (reference.type != TypeCode::Real && format != monitor::DisplayFormat::Real) return value.bits;
  const auto real = std::bit_cast<float>(value.bits);
  return std::isfinite(real) ? Json(real) : Json(nullptr);
}

WatchList::WatchList(std::vector<WatchItem> items, std::int64_t everyMs,
                     std::optional<monitor::Trigger> trigger)
    : trigger_(trigger), everyMs_(everyMs) {
  for (WatchItem& item : items) rows_.push_back({std::move(item), {}, {}, {}, false});
}

WatchExtent WatchList::extent() const {
  WatchExtent sum{.items = rows_.size()};
  for (const Row& row : rows_) sum.bytes += row.item.operand.size();
  return sum;
}

void WatchList::reached(const Plc& plc, monitor::CyclePoint point) {
  if (!trigger_ || trigger_->point != point || done_) return;
  for (Row& row : rows_) row.seen = read(row, plc);
  came_ = true;
  done_ = trigger_->once;
}

Json WatchList::describe(Row& row, const Plc& plc) {
  Json json = {{"operand", row.item.operand},
               {"symbol", ""},
               {"comment", ""},
               {"type", ""},
               {"bits", 0},
               {"format", monitor::name(row.item.format)}};
  row.reference.reset();
  row.told = false;
  if (row.item.problem) return json["problem"] = toJson(*row.item.problem), json;
  auto reference = plc.operand(row.item.operand);
  if (!reference) return json["problem"] = toJson(reference.error()), json;
  if (const auto problem = monitor::checkFormat(*reference, row.item.format))
    return json["problem"] = toJson(*problem), json;
  const OperandName name = operandName(*reference, plc.build().project.symbols);
  json["operand"] = name.operand;
  json["symbol"] = name.symbol;
  json["comment"] = name.comment;
  json["type"] = name.type;
  json["bits"] = name.bits;
  row.reference = std::move(*reference);
  return json;
}

Json WatchList::describe(const Plc& plc) {
  Json list = Json::array();
  for (Row& row : rows_) list.push_back(describe(row, plc));
  return list;
}

// Symbols and data blocks may lie elsewhere in another program.
void WatchList::bind(const Plc& plc, std::uint64_t program) {
  if (program_ != 0 && program_ != program) describe(plc);
  program_ = program;
}

// A variable of a block is that of the block which runs when it is looked at.
std::optional<monitor::Value> WatchList::read(const Row& row, const Plc& plc) {
  if (!row.item.operand.starts_with('#'))
    return row.reference ? plc.read(*row.reference) : std::nullopt;
  const auto now = plc.operand(row.item.operand);
  return now ? plc.read(*now) : std::nullopt;
}

Json WatchList::changes(const Plc& plc, std::uint64_t program, std::int64_t nowMs) {
  Json list = Json::array();
  bind(plc, program);
  if (nowMs < next_ || (trigger_ && !came_)) return list;
  next_ = nowMs + everyMs_;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    auto value = trigger_ ? row.seen : read(row, plc);
    if (row.told && value == row.last) continue;
    row.told = true;
    row.last = std::move(value);
    if (row.last && row.reference)
      list.push_back({i, monitor::show(*row.reference, *row.last, row.item.format),
                      rawValue(*row.reference, *row.last, row.item.format)});
    else
      list.push_back({i, "?", nullptr});
  }
  return list;
}

}  // namespace merker::workbench
