#include "technology/channel.h"

#include <algorithm>
#include <cstdlib>

#include "clock/standstill.h"
#include "technology/counter.h"
#include "technology/encoder_input.h"
#include "technology/frequency.h"
#include "technology/pulse_width.h"

namespace merker::technology {
namespace {

constexpr std::int32_t kMillihertzPerKilohertz = 1'000'000;

// 0.48 / f: 8 us at 60 kHz, 48 us at 10 kHz (CNT-PARAM-10).
Duration filterTime(std::uint32_t kilohertz) {
  return kilohertz == 0 ? Duration{} : Duration::microseconds(480 / kilohertz);
}

std::unique_ptr<Function> functionOf(const io::CountChannel& parameters, std::uint32_t highest) {
  switch (parameters.mode) {
    case io::CountMode::None:
      return nullptr;
    case io::CountMode::Frequency:
      return std::make_unique<Frequency>(
          parameters, static_cast<std::int32_t>(highest) * kMillihertzPerKilohertz);
    case io::CountMode::PulseWidth:
      return std::make_unique<PulseWidth>(parameters);
    default:
      return std::make_unique<Counter>(parameters);
  }
}

// Edges are rounded to nanoseconds each. Where a level lasts as long as the filter, one period
// passes and the next one may not.
bool onTheEdgeOfTheFilter(const Input& input, const signal::Period& period) {
  const std::int64_t width = (input.change() - input.since()).ns;
  const std::int64_t pause = period.numerator / period.denominator - width;
  const auto near = [&](std::int64_t length) { return std::abs(length - input.filter().ns) <= 2; };
  return near(width) || near(pause);
}

}  // namespace

Channel::Channel(const io::CountChannel& parameters, std::uint32_t highest)
    : parameters_(parameters), function_(functionOf(parameters, highest)) {
  for (Input& input : inputs_) input.setFilter(filterTime(parameters.maxFrequency));
  inputs_[LatchInput].setFilter(filterTime(parameters.latchFrequency));
}

void Channel::start(Instant now) {
  advance(now);
  if (function_ != nullptr) function_->start(inputs_[GateInput].passed(), now);
}

void Channel::stop() {
  if (function_ != nullptr) function_->stop();
}

void Channel::set(Name name, bool level, std::shared_ptr<const signal::Signal> signal,
                  Instant now) {
  pattern_ = {};
  inputs_[name].set(level, std::move(signal), now);
}

Instant Channel::nextInput() const {
  Instant next = Instant::never();
  for (const Input& input : inputs_) next = std::min(next, input.next());
  return next;
}

void Channel::advance(Instant now) {
  if (function_ == nullptr) return;
  for (Standstill loop;;) {
    const Instant at = std::min(nextInput(), function_->due());
    if (at > now || !loop.moves(at)) return;
    handle(at);
    if (pattern_.known && pattern_.begin == at) skip(now);
  }
}

// Levels that have lasted pass first: one that changes at this instant has lasted long enough.
void Channel::handle(Instant at) {
  const bool encoder = parameters_.evaluation != io::Evaluation::PulseDirection;
  const Name second = encoder ? TrackA : TrackB, third = encoder ? TrackB : TrackA;
  for (const Name name : {GateInput, LatchInput, second, third})  // CNT-ENC-06
    if (inputs_[name].due() == at) passed(name, at);
  for (Input& input : inputs_)
    if (input.change() == at) input.takeChange();
  const Input& a = inputs_[TrackA];
  if (a.since() == at && a.raw() && a.signal() != nullptr) closePeriod();
  if (function_->due() == at) function_->expire(at);
}

void Channel::passed(Name name, Instant at) {
  Input& input = inputs_[name];
  input.pass();
  const bool level = input.passed(), a = inputs_[TrackA].passed();
  const bool b = inputs_[TrackB].passed() != parameters_.inverted;
  if (name == GateInput) return function_->gateEdge(level, at);
  if (name == LatchInput) return level ? function_->latchEdge() : void();
  const int direction = name == TrackA ? edgeOfA(parameters_.evaluation, level, b)
                                       : edgeOfB(parameters_.evaluation, b, a);
  if (direction != 0) countPulse(direction, name, at);
}

void Channel::countPulse(int direction, Name input, Instant at) {
  (direction > 0 ? pattern_.up : pattern_.down) += 1;
  last_[1] = last_[0];
  last_[0] = {input, inputs_[input].since()};
  function_->pulse(direction, at);
}

void Channel::closePeriod() {
  Pattern next{.begin = inputs_[TrackA].since()};
  next.whole = pattern_.begin != Instant::never();
  next.upBefore = pattern_.up;
  next.downBefore = pattern_.down;
  const bool same = pattern_.up == pattern_.upBefore && pattern_.down == pattern_.downBefore;
  next.known = pattern_.whole && same && (pattern_.up == 0 || pattern_.down == 0);
  pattern_ = next;
}

// Of both tracks together; none if one of them has no part in it.
signal::Rhythm Channel::rhythm() const {
  const Input &a = inputs_[TrackA], &b = inputs_[TrackB];
  if (a.signal() == nullptr) return {};
  signal::Rhythm rhythm = a.signal()->rhythm(a.since());
  if (rhythm && onTheEdgeOfTheFilter(a, rhythm.period)) return {};
  if (b.change() == Instant::never() && b.settled()) return rhythm;
  if (b.signal() == nullptr) return {};
  const signal::Rhythm other = b.signal()->rhythm(b.since());
  if (!rhythm || !other || !(other.period == rhythm.period)) return {};
  rhythm.until = std::min(rhythm.until, other.until);
  return rhythm;
}

// How many whole periods from a rising edge of A change nothing but the count.
std::int64_t Channel::skippable(Instant now) const {
  const signal::Rhythm even = rhythm();
  if (!even) return 0;
  const Instant end = std::min(
      {now, even.until, inputs_[GateInput].next(), inputs_[LatchInput].next(), function_->due()});
  const signal::Grid grid{pattern_.begin, even.period};
  const auto fitting = static_cast<std::uint64_t>(std::max<std::int64_t>(grid.index(end) - 1, 0));
  if (pattern_.pulses() == 0) return static_cast<std::int64_t>(fitting);
  const std::uint64_t most = function_->absorbs(pattern_.direction()) / pattern_.pulses();
  return static_cast<std::int64_t>(std::min(most, fitting));
}

void Channel::skip(Instant now) {
  const std::int64_t periods = skippable(now);
  if (periods == 0) return;
  const bool single = pattern_.pulses() == 1;
  if (single) last_[1] = last_[0];
  if (pattern_.pulses() > 0)
    for (Pulse& pulse : last_)
      pulse.edge = inputs_[pulse.input].signal()->later(
          pulse.edge, single && &pulse == &last_[1] ? periods - 1 : periods);
  for (const Name name : {TrackA, TrackB})
    if (inputs_[name].change() != Instant::never()) inputs_[name].skip(periods);
  pattern_.begin = inputs_[TrackA].since();
  if (pattern_.pulses() > 0)
    function_->absorb(pattern_.direction(), static_cast<std::uint64_t>(periods) * pattern_.pulses(),
                      pulseTime(last_[0]), pulseTime(last_[1]));
}

// Where the next pulse that matters can come at the earliest.
Instant Channel::nextPulse() const {
  if (function_->absorbs(1) == kUnlimited && function_->absorbs(-1) == kUnlimited)
    return Instant::never();
  const Instant soon = std::min(inputs_[TrackA].next(), inputs_[TrackB].next());
  const signal::Rhythm even = pattern_.known ? rhythm() : signal::Rhythm{};
  if (!even) return soon;
  if (pattern_.pulses() == 0) return std::max(soon, even.until);
  const std::uint64_t room = function_->absorbs(pattern_.direction());
  const std::uint64_t periods = (room + pattern_.up + pattern_.down) / pattern_.pulses();
  constexpr std::uint64_t kFar = 1'000'000'000;
  const signal::Grid grid{pattern_.begin, even.period};
  const Instant then = grid.at(static_cast<std::int64_t>(std::min(periods, kFar)));
  return std::max(soon, std::min(then, even.until));
}

Instant Channel::nextVisible() const {
  return function_ == nullptr ? Instant::never() : std::min(next(), nextInput());
}

Instant Channel::next() const {
  if (function_ == nullptr || !function_->watched()) return Instant::never();
  const Instant gate = parameters_.hardwareGate ? inputs_[GateInput].next() : Instant::never();
  return std::min({function_->due(), gate, nextPulse()});
}

}  // namespace merker::technology
