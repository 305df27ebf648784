#include "workbench/status_view.h"

#include <algorithm>

#include "address/constant.h"

namespace merker::workbench {
namespace {

// A block that was not called for so long counts as not running.
constexpr std::int64_t kQuiet = 500;

std::string number(std::uint16_t block) { return block == 0 ? "-" : std::to_string(block); }

std::string pointer(const std::optional<std::uint32_t>& value) {
  return value ? formatConstant({ConstantFormat::Pointer, *value}) : "";
}

// [line, vke, sta, or, akku1, akku2, ar1, ar2, stw, db, di, values that these do not say]
Json rowOf(const monitor::StatusRow& row) {
  const monitor::Registers& r = row.after;
  const auto bit = [](bool value) { return value ? "1" : "0"; };
  return {row.statement.line,
          bit(r.rlo),
          bit(r.sta),
          bit(r.orBit),
          fmt::format("{:08X}", r.accu[0]),
          fmt::format("{:08X}", r.accu[1]),
          pointer(r.ar1),
          pointer(r.ar2),
          fmt::format("{:04X}", r.word),
          number(r.db),
          r.di ? number(*r.di) : ""};
}

// What the operands of a CALL held, by parameter, or the bit of S, R, FP and FN, by its name.
Json valuesAt(const monitor::ProgramStatus& status, std::uint32_t offset) {
  Json values = Json::object();
  const auto& calls = status.callValues();
  const auto call = std::ranges::lower_bound(calls, offset, {}, &monitor::CallValues::first);
  if (call == calls.end() || call->first != offset) return values;
  for (std::size_t i = 0; i < call->operands.size(); ++i)
    if (call->values[i])
      values[call->operands[i].parameter] = formatValue(call->operands[i].type, *call->values[i]);
  return values;
}

Json rowsOf(const monitor::ProgramStatus& status) {
  Json rows = Json::array();
  for (const monitor::StatusRow& row : status.rows()) {
    if (!row.reached) continue;
    rows.push_back(rowOf(row));
    rows.back().push_back(valuesAt(status, row.statement.begin));
  }
  return rows;
}

}  // namespace

Json StatusView::changes(monitor::Monitor& monitor, const ProjectFolder& folder,
                         std::int64_t nowMs) {
  const monitor::ProgramStatus* status = monitor.debugger().status(wish_.block, wish_.environment);
  if (status == nullptr) return nullptr;
  const Instant now = monitor.plc().now();
  const controller::Mode mode = monitor.plc().mode();
  const bool stands =
      mode == controller::Mode::Halt || mode == controller::Mode::Stop || now == at_;
  at_ = now;
  if (status->calls() != calls_ || stands) calls_ = status->calls(), since_ = nowMs;
  const bool quiet = calls_ == 0 || nowMs - since_ > kQuiet;
  Json event = {{"event", "status"},
                {"block", toString(wish_.block)},
                {"file", folder.relative(status->code().file())},
                {"instances", status->instances()},
                {"rows", quiet ? Json(nullptr) : rowsOf(*status)}};
  if (status->instance() && !quiet) event["instance"] = *status->instance();
  if (event == told_) return nullptr;
  told_ = event;
  event["calls"] = calls_;
  return event;
}

}  // namespace merker::workbench
