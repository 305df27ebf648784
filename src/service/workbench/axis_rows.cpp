#include "workbench/axis_rows.h"

#include <fmt/format.h>

#include <utility>

namespace merker::workbench {
namespace {

using io::AxisChannel;
using io::AxisMonitors;
using io::AxisOutput;

constexpr std::int64_t kFar = 500'000'000;  // pulses

// Rows of one page (POS-OVW-17).
class Page {
 public:
  Page(Json& list, const char* name) : list_(list), name_(name) {}

  void number(const char* key, std::int64_t value, std::int64_t low, std::int64_t high) {
    add(key, "number", value, {{"min", low}, {"max", high}});
  }
  void time(const char* key, std::int32_t value) {
    add(key, "length", fmt::format("{}ms", value), {{"hint", "2s"}});
  }
  void flag(const char* key, bool value) { add(key, "flag", value, Json::object()); }
  void fixed(const char* key, bool value) { add(key, "flag", value, {{"fixed", true}}); }
  void choice(const char* key, std::size_t chosen, Json choices) {
    Json value = choices[chosen];
    add(key, "choice", std::move(value), {{"choices", std::move(choices)}});
  }
  void frequency(const char* key, std::uint32_t kilohertz) {
    Json choices = Json::array();
    for (const std::uint32_t one : {60, 30, 10, 5, 2, 1})
      choices.push_back(fmt::format("{}kHz", one));
    add(key, "choice", fmt::format("{}kHz", kilohertz), {{"choices", std::move(choices)}});
  }

 private:
  void add(const char* key, const char* kind, Json value, Json more) {
    more.update({{"key", key}, {"kind", kind}, {"value", std::move(value)}, {"page", name_}});
    list_.push_back(std::move(more));
  }

  Json& list_;
  const char* name_;
};

template <typename Value>
std::size_t numberOf(Value value) {
  return static_cast<std::size_t>(value);
}

void addDrive(const AxisChannel& a, Json& list) {
  Page page(list, "drive");
  const bool analog = a.output == AxisOutput::Analog;
  page.number("target_range", a.targetRange, 0, 200'000'000);
  page.time("monitoring_time", a.monitoringTime);
  if (analog) {
    page.number("max_speed", a.highestSpeed, 10, 1'000'000);
    page.number("creep_speed", a.creepSpeed, 10, a.highestSpeed);
    page.time("cut_off_delay", a.cutOffDelay);
  }
  page.frequency("max_frequency", a.maxFrequency);
  page.frequency("switch_frequency", a.accompanyingFrequency);
  if (analog)
    page.choice("voltage", numberOf(a.analogControl), {"±10V", "0..10V"});
  else
    page.number("control_type", a.digitalControl, 1, 4);
  page.flag("monitor_actual_value", a.monitors.movement);
  page.flag("monitor_target_approach", a.monitors.approach);
  page.flag("monitor_target_range", a.monitors.targetRange);
}

void addAxis(const AxisChannel& a, Json& list) {
  Page page(list, "axis");
  page.choice("axis", numberOf(a.rotary), {"linear", "rotary"});
  if (a.rotary) {
    page.number("rotary_end", a.rotaryEnd, 1, 1'000'000'000);
  } else {
    page.number("low_limit", a.lowLimit, -kFar, kFar);
    page.number("high_limit", a.highLimit, -kFar, kFar);
  }
  page.choice("length_measurement", numberOf(a.lengthEdges),
              {"off", "rising", "falling", "rising to falling", "falling to rising"});
  page.number("reference_point", a.reference, -kFar, kFar);
  page.choice("reference_location", numberOf(a.referenceBelowSwitch), {"plus", "minus"});
  page.fixed("monitor_traversing_range", a.monitors.travel);  // POS-PARAM-22
  if (!a.rotary) page.flag("monitor_working_range", a.monitors.workingRange);
}

void addEncoder(const AxisChannel& a, Json& list) {
  Page page(list, "encoder");
  page.number("increments", a.increments, 1, 1 << 23);
  page.choice("count_direction", numberOf(a.inverted), {"normal", "inverted"});
  page.flag("monitor_missing_pulse", a.monitors.missingPulse);
}

void addDiagnosis(const AxisChannel& a, Json& list) {
  Page page(list, "diagnosis");
  const AxisMonitors& on = a.interrupts;
  page.flag("report_missing_pulse", on.missingPulse);
  page.flag("report_traversing_range", on.travel);
  if (!a.rotary) page.flag("report_working_range", on.workingRange);
  page.flag("report_actual_value", on.movement);
  page.flag("report_target_approach", on.approach);
  page.flag("report_target_range", on.targetRange);
}

}  // namespace

void addAxisRows(const io::Parameters& parameters, Json& list) {
  for (Json& row : list) row["page"] = row["key"] == "name" ? "general" : "addresses";
  const auto& axis = parameters.axis;
  Page basic(list, "basic");
  basic.choice("drive", axis ? 1 + numberOf(axis->output) : 0, {"none", "analog", "digital"});
  basic.choice("interrupts", numberOf(parameters.diagnosticInterrupt), {"none", "diagnostics"});
  if (!axis) return;
  addDrive(*axis, list);
  addAxis(*axis, list);
  addEncoder(*axis, list);
  addDiagnosis(*axis, list);
}

}  // namespace merker::workbench
