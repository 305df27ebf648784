#include "workbench/counting_rows.h"

#include <fmt/format.h>

#include <initializer_list>
#include <limits>
#include <utility>

#include "workbench/parameter_row.h"

namespace merker::workbench {
namespace {

using io::CountChannel;
using io::CountDirection;
using io::CountMode;

constexpr std::int64_t kHighest = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kLowest = std::numeric_limits<std::int32_t>::min();

// The rows of one channel.
class Rows {
 public:
  explicit Rows(const CountingType& type) : type_(type) {}

  template <typename Value>
  void choice(const char* key, Value value, std::initializer_list<const char*> words) {
    const Json choices(words);
    list_.push_back(parameterRow(key, "choice", choices[static_cast<std::size_t>(value)],
                                 {{"choices", choices}}));
  }
  void number(const char* key, std::int64_t value, std::int64_t low, std::int64_t high) {
    list_.push_back(parameterRow(key, "number", value, {{"min", low}, {"max", high}}));
  }
  void milliseconds(const char* key, std::int32_t value, const char* hint) {
    list_.push_back(parameterRow(key, "length", fmt::format("{}ms", value), {{"hint", hint}}));
  }
  void flag(const char* key, bool value) { list_.push_back(parameterRow(key, "flag", value)); }
  // 0: nothing has been set.
  void frequency(const char* key, std::uint32_t kilohertz) {
    Json choices = Json::array();
    for (const std::uint32_t one : type_.frequencies) choices.push_back(fmt::format("{}kHz", one));
    Json value = kilohertz == 0 ? choices[0] : Json(fmt::format("{}kHz", kilohertz));
    list_.push_back(
        parameterRow(key, "choice", std::move(value), {{"choices", std::move(choices)}}));
  }
  // Any of these causes.
  void interrupts(std::initializer_list<std::pair<const char*, bool>> causes) {
    Json value = Json::array(), choices = Json::array();
    for (const auto& [cause, selected] : causes) {
      choices.push_back(cause);
      if (selected) value.push_back(cause);
    }
    list_.push_back(
        parameterRow("interrupts", "causes", std::move(value), {{"choices", std::move(choices)}}));
  }
  Json take() { return std::move(list_); }

 private:
  const CountingType& type_;
  Json list_ = Json::array();
};

// CNT-PARAM-03 to -06: "endless" has no main direction.
void addDirection(const CountChannel& c, Rows& rows) {
  if (c.mode != CountMode::Endless)
    rows.choice("main_direction", c.direction, {"none", "forward", "backward"});
  const bool forward = c.direction == CountDirection::Forward;
  if (forward) rows.number("end_value", c.endValue, 2, kHighest);
  const bool backward = c.direction == CountDirection::Backward;
  if (backward) rows.number("start_value", c.endValue, 2, kHighest);
  rows.choice("gate", c.interruptGate, {"cancel", "interrupt"});
  rows.number("comparison_value", c.comparison, backward ? 1 : kLowest,
              forward ? std::int64_t{c.endValue} - 1 : kHighest);
}

// CNT-PARAM-07 to -19
void addCounting(const CountChannel& c, Rows& rows) {
  addDirection(c, rows);
  rows.number("hysteresis", c.hysteresis, 0, 255);
  rows.frequency("max_frequency", c.maxFrequency);
  rows.frequency("latch_frequency", c.latchFrequency);
  rows.choice("evaluation", c.evaluation, {"pulse", "single", "double", "quadruple"});
  rows.flag("hardware_gate", c.hardwareGate);
  rows.flag("inverted", c.inverted);
  rows.choice("output", c.output, {"none", ">=", "<=", "pulse"});
  rows.milliseconds("pulse_duration", c.pulseDuration, "0ms");
  if (c.maxFrequency == kMeasuringFrequency) {
    rows.choice("input_data", c.showPeriod, {"count", "period"});
    rows.choice("time_base", c.microseconds, {"125ns", "1us"});
  }
  rows.interrupts({{"gate opened", c.onGateOpened},
                   {"gate closed", c.onGateClosed},
                   {"comparator", c.onComparator},
                   {"overflow", c.onOverflow},
                   {"underflow", c.onUnderflow},
                   {"count edge", c.onCountEdge}});
}

// CNT-PARAM-20 to -28
void addFrequency(const CountChannel& c, const CountingType& type, Rows& rows) {
  const auto highest = std::int64_t{type.frequencies.front()} * 1'000'000;  // mHz
  rows.milliseconds("integration_time", c.integrationTime, "100ms");
  rows.number("low_limit", c.lowLimit, 0, highest - 1);
  rows.number("high_limit", c.highLimit, 1, highest);
  rows.frequency("max_frequency", c.maxFrequency);
  rows.choice("value", c.averaged, {"direct", "averaged"});
  rows.choice("evaluation", c.evaluation, {"pulse", "single"});
  rows.flag("hardware_gate", c.hardwareGate);
  rows.flag("inverted", c.inverted);
  rows.choice("output", c.limitOutput, {"none", "outside", "below", "above"});
  rows.interrupts({{"gate opened", c.onGateOpened},
                   {"gate closed", c.onGateClosed},
                   {"end of measurement", c.onMeasured},
                   {"low limit", c.onLowLimit},
                   {"high limit", c.onHighLimit}});
}

// CNT-PARAM-29 to -36
void addPulseWidth(const CountChannel& c, Rows& rows) {
  constexpr std::int64_t kMost = 65'535;
  rows.choice("format", c.analogFormat, {"per mille", "analog"});
  rows.choice("time_base", c.milliseconds, {"0.1ms", "1ms"});
  rows.number("on_delay", c.onDelay, 0, kMost);
  rows.number("period", c.period, c.milliseconds ? 1 : 4, kMost);
  rows.number("minimum_pulse", c.minimumPulse, c.milliseconds ? 0 : 2, c.period / 2);
  rows.flag("hardware_gate", c.hardwareGate);
  rows.frequency("max_frequency", c.maxFrequency);
  rows.interrupts({{"gate opened", c.onGateOpened}});
}

}  // namespace

Json countingRows(const CountChannel& channel, const CountingType& type) {
  Rows rows(type);
  rows.choice("mode", channel.mode, {"none", "endless", "once", "periodic", "frequency", "pwm"});
  if (channel.mode == CountMode::Frequency)
    addFrequency(channel, type, rows);
  else if (channel.mode == CountMode::PulseWidth)
    addPulseWidth(channel, rows);
  else if (channel.mode != CountMode::None)
    addCounting(channel, rows);
  return rows.take();
}

void dropCounting(project::SettingsEdit& edit, const project::ModulePlace& place,
                  std::uint32_t number, std::string_view key, std::string_view value) {
  constexpr std::string_view kSide = "number";
  const auto drop = [&](std::string_view one) {
    edit.setChannel(place, kSide, number, one, std::nullopt);
  };
  if (key == "mode") {
    for (const std::string& one : edit.channelKeys(place, kSide, number))
      if (one != kSide) drop(one);
  } else if (key == "main_direction") {
    for (const char* one : {"end_value", "start_value", "comparison_value"}) drop(one);
  } else if (key == "max_frequency" && value != "\"1kHz\"") {
    for (const char* one : {"input_data", "time_base"}) drop(one);
  }
}

}  // namespace merker::workbench
