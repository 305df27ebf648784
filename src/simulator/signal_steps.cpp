#include "simulator/signal_steps.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <set>

#include "base/text.h"
#include "io/amount.h"
#include "simulator/line.h"

namespace merker::simulator {
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
std::optional<std::int64_t> millihertz(std::string_view text) {
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
  void (*store)(SignalStep&, std::int64_t);
};
constexpr std::array kOptions = {
    Option{"duty", false, thousandths,
           [](SignalStep& s, std::int64_t v) { s.duty = static_cast<std::uint32_t>(v); }},
    Option{"jitter", false, thousandths,
           [](SignalStep& s, std::int64_t v) { s.jitter = static_cast<std::uint32_t>(v); }},
    Option{"high", false, nanoseconds, [](SignalStep& s, std::int64_t v) { s.high = v; }},
    Option{"low", false, nanoseconds, [](SignalStep& s, std::int64_t v) { s.low = v; }},
    Option{"seed", false, whole,
           [](SignalStep& s, std::int64_t v) { s.seed = static_cast<std::uint64_t>(v); }},
    Option{"count", false, whole, [](SignalStep& s, std::int64_t v) { s.count = v; }},
    Option{"count", true, whole, [](SignalStep& s, std::int64_t v) { s.count = 4 * v; }},
    Option{"quarters", true, whole, [](SignalStep& s, std::int64_t v) { s.count = v; }}};

bool readOption(std::string_view& rest, SignalStep& step) {
  const std::string_view key = takeWord(rest), value = takeWord(rest);
  for (const Option& option : kOptions) {
    if (option.encoder != step.encoder || !equalsIgnoreCase(option.key, key)) continue;
    const auto read = option.read(value);
    if (read) option.store(step, *read);
    return read.has_value();
  }
  return false;
}

signal::Pulses pulsesOf(const SignalStep& step, Instant now) {
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

bool parseSignal(std::string_view text, bool encoder, SignalStep& step, const PositionOf& at,
                 Problems& problems) {
  std::string_view rest = text;
  const auto fail = [&](std::string_view where, std::string_view expected) {
    problems.add(ProblemCode::P0952, at(where.empty() ? text : where), expected);
    return false;
  };
  step.encoder = encoder;
  for (int i = 0; i < (encoder ? 2 : 1); ++i) {
    const std::string_view name = takeTerminal(rest);
    TerminalValue& terminal = step.terminals.emplace_back();
    if (!parseTerminal(name, name, terminal, at, problems)) return false;
    if (terminal.side != io::Side::DigitalInput) return fail(name, "a digital input: MODULE.DI0");
    terminal.value.assign(1, '0');
  }
  if (encoder && step.terminals[0].text == step.terminals[1].text)
    return fail(step.terminals[1].text, "track B on another terminal than track A");
  std::string_view options = rest;
  const std::string_view first = takeWord(options);
  if (equalsIgnoreCase(first, "off")) {
    step.off = true;
    return options.empty() || fail(options, "nothing behind 'off'");
  }
  if (const auto frequency = millihertz(first); frequency && (encoder || *frequency > 0)) {
    step.millihertz = *frequency;
    rest = options;
  } else if (encoder || !equalsIgnoreCase(first, "high")) {
    return fail(first, encoder ? "a frequency up to 100kHz, as 60kHz or -1kHz (backward), or off"
                               : "a frequency up to 100kHz, as 1kHz, high 8us low 8us, or off");
  }
  std::set<std::string> seen;
  while (!rest.empty()) {
    const std::string_view before = rest;
    if (!readOption(rest, step)) return fail(before, encoder ? kEncoderKeys : kKeys);
    std::string_view word = before;
    if (!seen.insert(upper(takeWord(word))).second) return fail(before, "each of them once");
  }
  if (seen.contains("COUNT") && seen.contains("QUARTERS"))
    return fail(text, "count or quarters, not both");
  if (step.high != 0 && (step.millihertz != 0 || seen.contains("DUTY")))
    return fail(text, "either a frequency with its duty, or high and low");
  if (!encoder && step.millihertz == 0 && (step.high == 0 || step.low == 0))
    return fail(text, "high 8us low 8us: both");
  if (!encoder && step.jitter > signal::mostJitter(pulsesOf(step, {})) && step.jitter > 0)
    return fail(text, "less jitter than half of pulse and pause: edges keep their order");
  return true;
}

void resolve(SignalStep& step, const io::Configuration* hardware, Problems& problems) {
  for (TerminalValue& terminal : step.terminals) resolve(terminal, hardware, problems);
}

void apply(const SignalStep& step, Axes& axes, io::Rack& rack, Instant now) {
  const auto terminal = [&](std::size_t i) {
    const TerminalValue& value = step.terminals[i];
    return *rack.terminal(value.module, value.side, value.channel);
  };
  if (!step.encoder && step.off) return rack.setLevel(terminal(0), false, now);
  if (!step.encoder)
    return rack.attach(terminal(0), std::make_shared<signal::PulseTrain>(pulsesOf(step, now)), now);
  signal::Motion& axis = axes[step.terminals[0].text];
  axis = {now, axis.positionAt(now), step.millihertz, step.count};
  for (const auto track : {signal::Track::A, signal::Track::B})
    rack.attach(terminal(static_cast<std::size_t>(track)),
                std::make_shared<signal::EncoderTrack>(axis, track), now);
}

}  // namespace merker::simulator
