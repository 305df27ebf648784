// [[module.channel]] of the sub-module 2.4: the masks of the technology manual 5.3.2 to 5.3.5
// (CNT-PARAM).
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/text.h"
#include "catalogue/counting.h"
#include "project/readers.h"

namespace merker::project {
namespace {

using io::CountChannel;
using io::CountDirection;
using io::CountMode;

constexpr std::int64_t kHighest = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kLowest = std::numeric_limits<std::int32_t>::min();

// A channel being read, with what its CPU can do.
struct Reader {
  const Table& table;
  const CountingType& type;
  const CpuModel& model;
  CountChannel& channel;

  void integer(std::string_view key, std::int64_t low, std::int64_t high, std::int32_t& value) {
    if (const auto read = table.integer(key, low, high)) value = static_cast<std::int32_t>(*read);
  }
  void flag(std::string_view key, bool& value) { value = table.flag(key).value_or(value); }
  template <typename Value>
  void choice(std::string_view key, std::initializer_list<std::string_view> words, Value& value) {
    if (const auto read = table.choice(key, words)) value = static_cast<Value>(*read);
  }
  void needs(std::string_view key, std::string_view what) {
    table.problems().add(ProblemCode::P0744, table.placeOf(key), key, what);
  }
  void frequency(std::string_view key, std::uint32_t& value);
  void milliseconds(std::string_view key, std::int32_t low, std::int32_t high, std::int32_t& value);
  void interrupts(std::initializer_list<std::pair<std::string_view, bool*>> causes);
};

std::string frequencies(const CountingType& type) {
  std::string list;
  for (const std::uint32_t kilohertz : type.frequencies)
    list += fmt::format("{}{}kHz", list.empty() ? "" : ", ", kilohertz);
  return list;
}

void Reader::frequency(std::string_view key, std::uint32_t& value) {
  const auto text = table.text(key, "a frequency: \"10kHz\"");
  if (!text) return;
  for (const std::uint32_t kilohertz : type.frequencies)
    if (equalsIgnoreCase(*text, fmt::format("{}kHz", kilohertz))) {
      value = kilohertz;
      return;
    }
  table.problems().add(ProblemCode::P0737, table.at(key), fmt::format("{} \"{}\"", key, *text),
                       model.name, frequencies(type));
}

void Reader::milliseconds(std::string_view key, std::int32_t low, std::int32_t high,
                          std::int32_t& value) {
  const auto length = table.length(key, Duration::milliseconds(low), Duration::milliseconds(high));
  if (!length) return;
  value = static_cast<std::int32_t>(length->ns / 1'000'000);
  if (*length != Duration::milliseconds(value)) table.mustBe(key, "whole milliseconds");
}

// ["overflow", "comparator"]
void Reader::interrupts(std::initializer_list<std::pair<std::string_view, bool*>> causes) {
  std::string known;
  for (const auto& cause : causes)
    known += fmt::format("{}{}", known.empty() ? "" : ", ", cause.first);
  const auto list = table.texts("interrupts", "a list of causes: [\"gate opened\"]");
  if (!list) return;
  for (const Table::Text& wanted : *list) {
    const auto found = std::find_if(causes.begin(), causes.end(), [&](const auto& cause) {
      return equalsIgnoreCase(cause.first, wanted.text);
    });
    if (found != causes.end())
      *found->second = true;
    else
      table.problems().add(ProblemCode::P0737, wanted.position,
                           fmt::format("interrupt \"{}\"", wanted.text), "this mode", known);
  }
}

// Main direction, its end or start value, and the comparison value that depends on both
// (CNT-PARAM-03 to -06).
void readDirection(Reader& r) {
  CountChannel& c = r.channel;
  r.choice("main_direction", {"none", "forward", "backward"}, c.direction);
  if (c.mode == CountMode::Endless && c.direction != CountDirection::None)
    r.needs("main_direction", "mode = \"once\" or \"periodic\"");
  if (c.direction == CountDirection::Backward) c.comparison = 1;  // docs/compatibility.md
  const std::pair<std::string_view, CountDirection> ends[] = {
      {"end_value", CountDirection::Forward}, {"start_value", CountDirection::Backward}};
  for (const auto& [key, direction] : ends) {
    if (!r.table.has(key)) continue;
    if (c.direction != direction)
      r.needs(key, direction == CountDirection::Forward ? "main_direction = \"forward\""
                                                        : "main_direction = \"backward\"");
    else
      r.integer(key, 2, kHighest, c.endValue);
  }
  const std::int64_t low = c.direction == CountDirection::Backward ? 1 : kLowest;
  const std::int64_t high =
      c.direction == CountDirection::Forward ? std::int64_t{c.endValue} - 1 : kHighest;
  r.integer("comparison_value", low, high, c.comparison);
}

void readOutput(Reader& r) {
  CountChannel& c = r.channel;
  r.choice("output", {"none", ">=", "<=", "pulse"}, c.output);
  r.integer("hysteresis", 0, 255, c.hysteresis);
  r.milliseconds("pulse_duration", 0, 510, c.pulseDuration);
  if (c.pulseDuration % 2 != 0) r.table.mustBe("pulse_duration", "an even number of milliseconds");
}

// Interrupts that nothing can cause.
void checkCauses(Reader& r) {
  const CountChannel& c = r.channel;
  const auto never = [&](bool selected, std::string_view cause, std::string_view why) {
    if (selected)
      r.table.problems().add(ProblemCode::P0766, r.table.placeOf("interrupts"), cause, why);
  };
  never(c.onGateOpened && !c.hardwareGate, "gate opened", "hardware_gate is not true");
  never(c.onGateClosed && !c.hardwareGate, "gate closed", "hardware_gate is not true");
}

// CNT-PARAM-16, -17, -19
void readMeasuring(Reader& r) {
  CountChannel& c = r.channel;
  r.choice("input_data", {"count", "period"}, c.showPeriod);
  r.choice("time_base", {"125ns", "1us"}, c.microseconds);
  if (c.maxFrequency == kMeasuringFrequency) return;
  if (c.showPeriod) r.needs("input_data", "max_frequency = \"1kHz\"");
  if (c.onCountEdge) r.needs("interrupts", "max_frequency = \"1kHz\" for \"count edge\"");
}

void readCounting(Reader& r) {
  r.table.allow({"number", "mode", "main_direction", "end_value", "start_value", "gate",
                 "comparison_value", "hysteresis", "max_frequency", "latch_frequency", "evaluation",
                 "hardware_gate", "inverted", "output", "pulse_duration", "input_data", "time_base",
                 "interrupts"});
  CountChannel& c = r.channel;
  c.latchFrequency = 10;
  r.frequency("max_frequency", c.maxFrequency);
  r.frequency("latch_frequency", c.latchFrequency);
  readDirection(r);
  r.choice("gate", {"cancel", "interrupt"}, c.interruptGate);
  r.choice("evaluation", {"pulse", "single", "double", "quadruple"}, c.evaluation);
  r.flag("hardware_gate", c.hardwareGate);
  r.flag("inverted", c.inverted);
  readOutput(r);
  r.interrupts({{"gate opened", &c.onGateOpened},
                {"gate closed", &c.onGateClosed},
                {"comparator", &c.onComparator},
                {"overflow", &c.onOverflow},
                {"underflow", &c.onUnderflow},
                {"count edge", &c.onCountEdge}});
  checkCauses(r);
  readMeasuring(r);
}

// CNT-PARAM-20 to -28
void readFrequency(Reader& r) {
  r.table.allow({"number", "mode", "integration_time", "low_limit", "high_limit", "max_frequency",
                 "value", "evaluation", "hardware_gate", "inverted", "output", "interrupts"});
  CountChannel& c = r.channel;
  const auto highest = static_cast<std::int32_t>(r.type.frequencies.front() * 1'000'000);  // mHz
  c.highLimit = highest;
  r.frequency("max_frequency", c.maxFrequency);
  r.milliseconds("integration_time", 10, 10'000, c.integrationTime);
  r.integer("high_limit", 1, highest, c.highLimit);
  r.integer("low_limit", 0, highest - 1, c.lowLimit);
  if (c.lowLimit >= c.highLimit)
    r.table.mustBe(r.table.has("low_limit") ? "low_limit" : "high_limit",
                   r.table.has("low_limit") ? "below high_limit" : "above low_limit");
  r.choice("value", {"direct", "averaged"}, c.averaged);
  r.choice("evaluation", {"pulse", "single"}, c.evaluation);
  r.flag("hardware_gate", c.hardwareGate);
  r.flag("inverted", c.inverted);
  r.choice("output", {"none", "outside", "below", "above"}, c.limitOutput);
  r.interrupts({{"gate opened", &c.onGateOpened},
                {"gate closed", &c.onGateClosed},
                {"end of measurement", &c.onMeasured},
                {"low limit", &c.onLowLimit},
                {"high limit", &c.onHighLimit}});
}

// CNT-PARAM-29 to -36
void readPulseWidth(Reader& r) {
  r.table.allow({"number", "mode", "format", "time_base", "on_delay", "period", "minimum_pulse",
                 "hardware_gate", "max_frequency", "interrupts"});
  CountChannel& c = r.channel;
  r.frequency("max_frequency", c.maxFrequency);
  r.choice("format", {"per mille", "analog"}, c.analogFormat);
  r.choice("time_base", {"0.1ms", "1ms"}, c.milliseconds);
  r.integer("on_delay", 0, 65'535, c.onDelay);
  r.integer("period", c.milliseconds ? 1 : 4, 65'535, c.period);
  r.integer("minimum_pulse", c.milliseconds ? 0 : 2, c.period / 2, c.minimumPulse);
  if (2 * c.minimumPulse > c.period) r.table.mustBe("period", "at least twice minimum_pulse");
  r.flag("hardware_gate", c.hardwareGate);
  r.interrupts({{"gate opened", &c.onGateOpened}});
}

void readCounter(Reader& r) {
  CountChannel& c = r.channel;
  c.maxFrequency = r.type.frequencies.front();
  r.choice("mode", {"none", "endless", "once", "periodic", "frequency", "pwm"}, c.mode);
  switch (c.mode) {
    case CountMode::None:
      r.table.allow({"number", "mode"});
      return;
    case CountMode::Frequency:
      return readFrequency(r);
    case CountMode::PulseWidth:
      return readPulseWidth(r);
    default:
      return readCounting(r);
  }
}

}  // namespace

// CNT-PARAM-02, POS-PARAM-01
void readInterruptSelection(const Table& table, io::Module& module) {
  if (module.type->kind == ModuleKind::Positioning) {
    if (const auto selected = table.choice("interrupts", {"none", "diagnostics"}))
      module.parameters.diagnosticInterrupt = *selected == 1;
    return;
  }
  const auto selected =
      table.choice("interrupts", {"none", "diagnostics", "process", "diagnostics and process"});
  if (!selected) return;
  if (module.type->kind != ModuleKind::Counting) {
    table.problems().add(ProblemCode::P0735, table.placeOf("interrupts"), module.title(),
                         "interrupt selection; only the sub-modules 2.4 and 2.5 have one");
    return;
  }
  module.parameters.diagnosticInterrupt = *selected == 1 || *selected == 3;
  module.parameters.hardwareInterrupt = *selected >= 2;
}

void readCounters(const Table& table, const CpuModel& model, io::Module& module) {
  const CountingType* type = countingType(model);
  if (type == nullptr) return;
  const auto count = static_cast<std::uint32_t>(type->channels.size());
  std::uint32_t seen = 0;
  for (const Table& channel : table.tables("channel")) {
    const auto number = channel.number("number", 0, 255);
    if (!number) {
      if (!channel.has("number")) channel.mustBe("number", "specified: the channel, from 0");
      continue;
    }
    if (*number >= count) {
      channel.problems().add(ProblemCode::P0738, channel.at("number"), *number, model.name,
                             fmt::format("channels 0 to {}", count - 1));
      continue;
    }
    if ((seen >> *number & 1) != 0)
      channel.problems().add(ProblemCode::P0745, channel.at("number"), *number);
    seen |= 1u << *number;
    Reader reader{channel, *type, model, module.parameters.counters[*number]};
    readCounter(reader);
    if (channel.has("interrupts") && !module.parameters.hardwareInterrupt)
      channel.problems().add(ProblemCode::P0768, channel.placeOf("interrupts"));
  }
}

}  // namespace merker::project
