// [[module]] of the sub-module 2.5: the pages of the technology manual 3.2.3 to 3.2.7 and 4.2.3 to
// 4.2.7 (POS-PARAM).
#include "project/axis_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "positioning/motion.h"
#include "project/readers.h"

namespace merker::project {
namespace {

using io::AxisChannel;
using io::AxisOutput;

constexpr std::int64_t kCountsEachPeriod = 4;                        // fourfold evaluation
constexpr std::uint32_t kAxisFrequencies[] = {60, 30, 10, 5, 2, 1};  // kHz

// What a key needs beside it (POS-PARAM-15, -23, -31).
struct KeyCondition {
  std::string_view key, needs;
  bool (*holds)(const AxisChannel&);
};
bool isAnalog(const AxisChannel& a) { return a.output == AxisOutput::Analog; }
bool isDigital(const AxisChannel& a) { return a.output == AxisOutput::Digital; }
bool isLinear(const AxisChannel& a) { return !a.rotary; }
bool isRotary(const AxisChannel& a) { return a.rotary; }
constexpr KeyCondition kKeyConditions[] = {
    {"max_speed", "drive = \"analog\"", isAnalog},
    {"creep_speed", "drive = \"analog\"", isAnalog},
    {"cut_off_delay", "drive = \"analog\"", isAnalog},
    {"voltage", "drive = \"analog\"", isAnalog},
    {"control_type", "drive = \"digital\"", isDigital},
    {"low_limit", "axis = \"linear\"", isLinear},
    {"high_limit", "axis = \"linear\"", isLinear},
    {"monitor_working_range", "axis = \"linear\"", isLinear},
    {"report_working_range", "axis = \"linear\"", isLinear},
    {"rotary_end", "axis = \"rotary\"", isRotary},
};

struct AxisReader {
  const Table& table;
  AxisChannel& axis;

  void integer(std::string_view key, std::int64_t low, std::int64_t high, std::int32_t& value) {
    if (const auto read = table.integer(key, low, high)) value = static_cast<std::int32_t>(*read);
  }
  void milliseconds(std::string_view key, std::int32_t& value) {
    constexpr std::uint32_t kLongest = 100'000;
    if (const auto read = table.milliseconds(key, 0, kLongest))
      value = static_cast<std::int32_t>(*read);
  }
  void flag(std::string_view key, bool& value) { value = table.flag(key).value_or(value); }
  template <typename Value>
  void choice(std::string_view key, std::initializer_list<std::string_view> words, Value& value) {
    if (const auto read = table.choice(key, words)) value = static_cast<Value>(*read);
  }
  void frequency(std::string_view key, std::uint32_t& value);
};

void AxisReader::frequency(std::string_view key, std::uint32_t& value) {
  const auto text = table.text(key, "a frequency: \"10kHz\"");
  if (!text) return;
  std::string known;
  for (const std::uint32_t kilohertz : kAxisFrequencies) {
    const std::string name = fmt::format("{}kHz", kilohertz);
    if (equalsIgnoreCase(*text, name)) value = kilohertz;
    if (equalsIgnoreCase(*text, name)) return;
    known += (known.empty() ? "" : ", ") + name;
  }
  table.problems().add(ProblemCode::P0737, table.at(key), fmt::format("{} \"{}\"", key, *text),
                       "the axis", known);
}

constexpr std::int64_t kFarthest = 500'000'000, kRoundest = 1'000'000'000;  // pulses

void readDrive(AxisReader& r) {
  AxisChannel& a = r.axis;
  r.integer("target_range", 0, 200'000'000, a.targetRange);
  r.milliseconds("monitoring_time", a.monitoringTime);
  r.integer("max_speed", 10, 1'000'000, a.highestSpeed);
  r.integer("creep_speed", 10, 1'000'000, a.creepSpeed);
  r.milliseconds("cut_off_delay", a.cutOffDelay);
  r.frequency("max_frequency", a.maxFrequency);
  r.frequency("switch_frequency", a.accompanyingFrequency);
  if (r.table.has("voltage"))
    if (const auto read = r.table.choice("voltage", {"±10V", "+-10V", "0..10V"}))
      a.analogControl = *read == 2 ? io::AnalogControl::WithDirection : io::AnalogControl::Bipolar;
  if (const auto type = r.table.number("control_type", 1, 4))
    a.digitalControl = static_cast<std::uint8_t>(*type);
}

void readAxis(AxisReader& r) {
  AxisChannel& a = r.axis;
  r.integer("low_limit", -kFarthest, kFarthest, a.lowLimit);
  r.integer("high_limit", -kFarthest, kFarthest, a.highLimit);
  r.integer("rotary_end", 1, kRoundest, a.rotaryEnd);
  r.choice("length_measurement",
           {"off", "rising", "falling", "rising to falling", "falling to rising"}, a.lengthEdges);
  r.integer("reference_point", -kFarthest, kFarthest, a.reference);
  r.choice("reference_location", {"plus", "minus"}, a.referenceBelowSwitch);
  r.integer("increments", 1, 1 << 23, a.increments);
  r.choice("count_direction", {"normal", "inverted"}, a.inverted);
}

// A monitor, its switch, and the one of its diagnostic interrupt (POS-PARAM-27).
struct AxisMonitor {
  std::string_view name, monitor, report;
  bool io::AxisMonitors::*member;
};
constexpr AxisMonitor kAxisMonitors[] = {
    {"missing pulse", "monitor_missing_pulse", "report_missing_pulse",
     &io::AxisMonitors::missingPulse},
    {"traversing range", "monitor_traversing_range", "report_traversing_range",
     &io::AxisMonitors::travel},
    {"working range", "monitor_working_range", "report_working_range",
     &io::AxisMonitors::workingRange},
    {"actual value", "monitor_actual_value", "report_actual_value", &io::AxisMonitors::movement},
    {"target approach", "monitor_target_approach", "report_target_approach",
     &io::AxisMonitors::approach},
    {"target range", "monitor_target_range", "report_target_range",
     &io::AxisMonitors::targetRange}};

void readMonitors(AxisReader& r, const io::Module& module) {
  AxisChannel& a = r.axis;
  for (const AxisMonitor& monitor : kAxisMonitors) {
    r.flag(monitor.monitor, a.monitors.*monitor.member);
    r.flag(monitor.report, a.interrupts.*monitor.member);
    if (!(a.interrupts.*monitor.member)) continue;
    const bool selected = module.parameters.diagnosticInterrupt;
    if (!selected || !(a.monitors.*monitor.member))
      r.table.problems().add(ProblemCode::P0766, r.table.placeOf(monitor.report), monitor.name,
                             selected ? fmt::format("{} is not true", monitor.monitor)
                                      : "interrupts is not \"diagnostics\"");
  }
  if (!a.monitors.travel)  // POS-PARAM-22
    r.table.mustBe("monitor_traversing_range", "true: it cannot be switched off");
}

bool conditionsHold(const Table& table, const AxisChannel& axis) {
  bool all = true;
  for (const KeyCondition& condition : kKeyConditions) {
    if (!table.has(condition.key) || condition.holds(axis)) continue;
    table.problems().add(ProblemCode::P0744, table.placeOf(condition.key), condition.key,
                         condition.needs);
    all = false;
  }
  return all;
}

// Rules between parameters (POS-PARAM-03, -06, -16, -19). The key that is written is shown.
void checkTogether(const Table& table, const AxisChannel& a) {
  const auto within = [](std::int64_t value, std::int64_t low, std::int64_t high) {
    return value >= low && value <= high;
  };
  if (isAnalog(a) && a.creepSpeed > a.highestSpeed)
    table.has("creep_speed")
        ? table.mustBe("creep_speed", fmt::format("at most max_speed, {}", a.highestSpeed))
        : table.mustBe("max_speed", fmt::format("at least creep_speed, {}", a.creepSpeed));
  if (a.rotary) {
    if (!within(a.reference, 0, std::int64_t{a.rotaryEnd} - 1))
      table.mustBe("reference_point", fmt::format("0 to {}, below rotary_end", a.rotaryEnd - 1));
    if (2 * positioning::halfRange(a) > a.rotaryEnd)
      table.mustBe("target_range", fmt::format("at most rotary_end, {}", a.rotaryEnd));
    return;
  }
  if (a.lowLimit >= a.highLimit) return table.mustBe("high_limit", "above low_limit");
  const std::int64_t range = std::int64_t{a.highLimit} - a.lowLimit;
  if (!within(a.reference, a.lowLimit, a.highLimit))
    table.mustBe("reference_point",
                 fmt::format("{} to {}, from low_limit to high_limit", a.lowLimit, a.highLimit));
  if (2 * positioning::halfRange(a) > range)
    table.mustBe("target_range", fmt::format("at most the range of the axis, {}", range));
}

// What works, but hardly as it is meant.
void noteDoubts(const Table& table, const AxisChannel& a) {
  const std::int64_t turn = std::int64_t{a.increments} * kCountsEachPeriod;
  if (a.rotary && a.rotaryEnd % turn != 0 && turn % a.rotaryEnd != 0)  // POS-PARAM-28
    table.problems().add(ProblemCode::P0772, table.placeOf("rotary_end"), turn);
  const std::int64_t countable = std::int64_t{a.maxFrequency} * 1000 * kCountsEachPeriod;
  if (isAnalog(a) && a.highestSpeed > countable)  // POS-ENC-10
    table.problems().add(ProblemCode::P0773, table.placeOf("max_speed"), a.maxFrequency, countable);
}

}  // namespace

const std::vector<std::string_view>& axisKeys() {
  static const std::vector<std::string_view> kKeys = [] {
    std::vector<std::string_view> keys{"drive",
                                       "target_range",
                                       "monitoring_time",
                                       "max_speed",
                                       "creep_speed",
                                       "cut_off_delay",
                                       "max_frequency",
                                       "switch_frequency",
                                       "voltage",
                                       "control_type",
                                       "axis",
                                       "low_limit",
                                       "high_limit",
                                       "rotary_end",
                                       "increments",
                                       "length_measurement",
                                       "reference_point",
                                       "reference_location",
                                       "count_direction"};
    for (const AxisMonitor& monitor : kAxisMonitors) {
      keys.push_back(monitor.monitor);
      keys.push_back(monitor.report);
    }
    return keys;
  }();
  return kKeys;
}

void readAxis(const Table& table, io::Module& module) {
  const auto drive = table.choice("drive", {"none", "analog", "digital"});
  if (!drive || *drive == 0) {
    for (const std::string_view key : axisKeys())
      if (key != "drive" && table.has(key))
        table.problems().add(ProblemCode::P0744, table.placeOf(key), key,
                             "drive = \"analog\" or \"digital\"");
    return;
  }
  AxisChannel axis;
  axis.output = *drive == 1 ? AxisOutput::Analog : AxisOutput::Digital;
  AxisReader reader{table, axis};
  reader.choice("axis", {"linear", "rotary"}, axis.rotary);
  if (axis.rotary) axis.monitors.workingRange = false;
  const std::size_t before = table.problems().list().size();
  const bool fits = conditionsHold(table, axis);
  readDrive(reader);
  readAxis(reader);
  readMonitors(reader, module);
  if (fits && table.problems().list().size() == before) checkTogether(table, axis);
  noteDoubts(table, axis);
  module.parameters.axis = axis;
}

namespace {

constexpr std::string_view kAxisSlot = "2.5";

// The table of a sub-module, if the file has it.
std::optional<Table> subModule(const Table& root, std::string_view slot) {
  for (const Table& table : root.tables("module"))
    if (const toml::node* node = table.node("slot"); node != nullptr && slotText(*node) == slot)
      return table;
  return std::nullopt;
}

// A counter that has the inputs of the axis: refused at whichever stands below the other
// (POS-OVW-05, -06).
void checkCounters(const Table& root, const Table& axis, const io::Parameters& counting) {
  constexpr std::uint32_t kShared = 2;
  const auto module = subModule(root, "2.4");
  if (!module) return;
  for (const Table& channel : module->tables("channel")) {
    const auto number = channel.has("number") ? channel.number("number", 0, 255) : std::nullopt;
    if (!number || *number >= kShared) continue;
    if (counting.counters[*number].mode == io::CountMode::None) continue;
    const bool axisBelow = axis.place().line > channel.place().line;
    const Table& wrong = axisBelow ? axis : channel;
    const std::string_view key = axisBelow ? "drive" : "mode";
    wrong.problems().add(
        ProblemCode::P0744, wrong.placeOf(key), key,
        axisBelow ? fmt::format("mode = \"none\" of counter {} (slot 2.4): they share their inputs",
                                *number)
                  : std::string("drive = \"none\" in slot 2.5: the axis has the inputs of counters "
                                "0 and 1"));
  }
}

}  // namespace

void checkAxis(const Table& root, const io::Configuration& configuration) {
  if (configuration.axis() == nullptr) return;
  const auto table = subModule(root, kAxisSlot);
  if (!table) return;
  if (const io::Module* counting = configuration.find("2.4"))
    checkCounters(root, *table, counting->parameters);
  const io::Module* analog = configuration.find("2.3");
  if (analog == nullptr || !io::isOfAxis(configuration, *analog, 0)) return;
  if (analog->parameters.analogOutputs[0].range != nullptr)  // POS-OVW-07
    table->problems().add(ProblemCode::P0744, table->placeOf("drive"), "drive",
                          "range = \"off\" of output 0 in slot 2.3: AO 0 belongs to the axis");
}

}  // namespace merker::project
