#include "scenario/steps/signal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <set>

#include "base/text.h"
#include "io/amount.h"
#include "plant/field.h"
#include "signal/encoder.h"
#include "signal/pulse_train.h"

namespace merker::simulator::steps {
namespace {

constexpr std::int64_t kHighest = 100'000'000;  // mHz (CNT-SIM-04)
constexpr std::string_view kKeys =
    "duty 50%, high 8us, low 8us, count 100, jitter 10%, seed 7 or nothing";
constexpr std::string_view kEncoderKeys = "count 10 (periods), quarters 3 or nothing";

// A name in quotation marks may have blanks: "Fill level".DI0
std::string_view takeTerminal(std::string_view& text) {
  bool quoted = false;
  std::size_t end = 0;
  for (; end < text.size() && (quoted || (text[end] != ' ' && text[end] != '\t')); ++end)
    if (text[end] == '"') quoted = !quoted;
  const std::string_view name = text.substr(0, end);
  text = trim(text.substr(end));
  return name;
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// A number with this unit behind it; upper and lower case are the same.
std::optional<double> withUnit(std::string_view text, std::string_view unit) {
  if (text.size() <= unit.size() || !equalsIgnoreCase(text.substr(text.size() - unit.size()), unit))
    return std::nullopt;
  return number(text.substr(0, text.size() - unit.size()));
}

// "60kHz", "123.456Hz", "-1kHz"
std::optional<std::int64_t> frequencyOf(std::string_view text) {
  auto value = withUnit(text, "kHz");
  if (value)
    *value *= 1e6;
  else if ((value = withUnit(text, "Hz")))
    *value *= 1e3;
  if (!value || std::abs(*value) < 1 || std::abs(*value) > kHighest) return std::nullopt;
  return std::llround(*value);
}

std::optional<std::int64_t> whole(std::string_view text) {
  const auto value = number(text);
  const bool good = value && *value >= 1 && *value <= 1e12 && std::floor(*value) == *value;
  return good ? std::optional(static_cast<std::int64_t>(*value)) : std::nullopt;
}

std::optional<std::int64_t> thousandths(std::string_view text) {
  const auto value = withUnit(text, "%");
  if (!value || *value <= 0 || *value >= 100) return std::nullopt;
  return std::llround(*value * 10);
}

std::optional<std::int64_t> nanoseconds(std::string_view text) {
  if (const auto us = withUnit(text, "us"))
    return *us > 0 ? std::optional(std::llround(*us * 1e3)) : std::nullopt;
  const auto length = io::parseLength(text);
  return length && length->ns > 0 ? std::optional(length->ns) : std::nullopt;
}

struct Option {
  std::string_view key;
  bool encoder;
  std::optional<std::int64_t> (*read)(std::string_view);
  void (*store)(Signal&, std::int64_t);
};
constexpr std::array kOptions = {
    Option{"duty", false, thousandths,
           [](Signal& s, std::int64_t v) { s.duty = static_cast<std::uint32_t>(v); }},
    Option{"jitter", false, thousandths,
           [](Signal& s, std::int64_t v) { s.jitter = static_cast<std::uint32_t>(v); }},
    Option{"high", false, nanoseconds, [](Signal& s, std::int64_t v) { s.high = v; }},
    Option{"low", false, nanoseconds, [](Signal& s, std::int64_t v) { s.low = v; }},
    Option{"seed", false, whole,
           [](Signal& s, std::int64_t v) { s.seed = static_cast<std::uint64_t>(v); }},
    Option{"count", false, whole, [](Signal& s, std::int64_t v) { s.count = v; }},
    Option{"count", true, whole, [](Signal& s, std::int64_t v) { s.count = 4 * v; }},
    Option{"quarters", true, whole, [](Signal& s, std::int64_t v) { s.count = v; }}};

bool readOption(std::string_view& rest, Signal& step) {
  const std::string_view key = takeWord(rest), value = takeWord(rest);
  for (const Option& option : kOptions) {
    if (option.encoder != step.encoder || !equalsIgnoreCase(option.key, key)) continue;
    const auto read = option.read(value);
    if (read) option.store(step, *read);
    return read.has_value();
  }
  return false;
}

signal::Pulses pulsesOf(const Signal& step, Instant now) {
  signal::Pulses pulses;
  if (step.millihertz != 0) {
    pulses = signal::pulsesOf(step.millihertz, step.duty, now);
  } else {
    pulses.start = now;
    pulses.period = {step.high + step.low, 1};
    pulses.high = step.high;
  }
  pulses.count = step.count;
  pulses.jitter = step.jitter;
  pulses.seed = step.seed;
  return pulses;
}

}  // namespace

bool Signal::parse(const StepLine& line) {
  const std::string_view text = line.rest();
  std::string_view rest = text;
  const auto wrong = [&](std::string_view where, std::string_view expected) {
    return line.fail(ProblemCode::P0952, where.empty() ? text : where, expected);
  };
  std::string_view name;
  for (int i = 0; i < (encoder ? 2 : 1); ++i) {
    name = takeTerminal(rest);
    TerminalValue& terminal = terminals.emplace_back();
    if (!parseTerminal(name, name, terminal, line.positions(), line.problems())) return false;
    if (terminal.side != io::Side::DigitalInput) return wrong(name, "a digital input: MODULE.DI0");
    terminal.value.assign(1, '0');
  }
  if (encoder && terminals[0].text == terminals[1].text)
    return wrong(name, "track B on another terminal than track A");
  std::string_view options = rest;
  const std::string_view first = takeWord(options);
  if (equalsIgnoreCase(first, "off")) {
    off = true;
    return options.empty() || wrong(options, "nothing after 'off'");
  }
  if (const auto frequency = frequencyOf(first); frequency && (encoder || *frequency > 0)) {
    millihertz = *frequency;
    rest = options;
  } else if (encoder || !equalsIgnoreCase(first, "high")) {
    return wrong(first, encoder ? "a frequency up to 100kHz: 60kHz or -1kHz (backward), or off"
                                : "a frequency up to 100kHz: 1kHz, high 8us low 8us, or off");
  }
  std::set<std::string> seen;
  while (!rest.empty()) {
    const std::string_view before = rest;
    if (!readOption(rest, *this)) return wrong(before, encoder ? kEncoderKeys : kKeys);
    std::string_view word = before;
    if (!seen.insert(upper(takeWord(word))).second) return wrong(before, "each of them only once");
  }
  if (seen.contains("COUNT") && seen.contains("QUARTERS"))
    return wrong(text, "count or quarters, not both");
  if (high != 0 && (millihertz != 0 || seen.contains("DUTY")))
    return wrong(text, "either a frequency with its duty, or high and low");
  if (!encoder && millihertz == 0 && (high == 0 || low == 0))
    return wrong(text, "high 8us low 8us: both");
  if (!encoder && jitter > signal::mostJitter(pulsesOf(*this, {})) && jitter > 0)
    return wrong(text, "less jitter than half of pulse and pause: edges keep their order");
  return true;
}

// A train of pulses would end with the next change of a plant that drives its terminal.
static void checkDriver(const TerminalValue& terminal, const StepBinding& binding) {
  const io::Module* module =
      binding.hardware == nullptr ? nullptr : binding.hardware->find(terminal.module);
  if (module == nullptr || binding.plants == nullptr) return;
  const auto index = static_cast<std::uint32_t>(module - binding.hardware->modules.data());
  const std::string driver = binding.plants->driverOf({index, terminal.side, terminal.channel});
  if (!driver.empty())
    binding.problems.add(ProblemCode::P0988, terminal.position, terminal.text,
                         "it is wired to " + driver);
}

void Signal::resolve(const StepBinding& binding) {
  for (TerminalValue& terminal : terminals)
    simulator::resolve(terminal, binding.hardware, binding.problems);
  for (const TerminalValue& terminal : terminals) checkDriver(terminal, binding);
}

bool Signal::perform(StepRun& run) const {
  auto* const field = run.need<plant::Field>();
  if (field == nullptr) return false;
  io::Rack& rack = *field->rack();
  const Instant now = run.plc().now();
  const auto terminal = [&](std::size_t i) {
    const TerminalValue& value = terminals[i];
    return *rack.terminal(value.module, value.side, value.channel);
  };
  if (!encoder && off) {
    rack.setLevel(terminal(0), false, now);
    return true;
  }
  if (!encoder) {
    rack.attach(terminal(0), std::make_shared<signal::PulseTrain>(pulsesOf(*this, now)), now);
    return true;
  }
  signal::Motion& axis = run.axes()[terminals[0].text];
  axis = {now, axis.positionAt(now), millihertz, count};
  for (const auto track : {signal::Track::A, signal::Track::B})
    rack.attach(terminal(static_cast<std::size_t>(track)),
                std::make_shared<signal::EncoderTrack>(axis, track), now);
  return true;
}

}  // namespace merker::simulator::steps
