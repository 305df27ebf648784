#include "technology/comparator.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "technology/function.h"

namespace merker::technology {
namespace {

std::int64_t distance(std::int32_t a, std::int32_t b) {
  return std::abs(std::int64_t{a} - std::int64_t{b});
}

}  // namespace

bool Comparator::isMain(int direction) const {
  if (main_ == io::CountDirection::None) return true;
  return direction == (main_ == io::CountDirection::Forward ? 1 : -1);
}

bool Comparator::condition(std::int32_t count, int direction) const {
  switch (output_) {
    case io::CountOutput::AtLeast:
      return count >= value;
    case io::CountOutput::AtMost:
      return count <= value;
    case io::CountOutput::Pulse:  // in the main direction only (CNT-CMP-09)
      return count == value && isMain(direction);
    case io::CountOutput::None:  // what its hardware interrupt waits for (5.5.12)
      return count == value;
  }
  return false;
}

bool Comparator::left(std::int32_t count) const { return distance(count, value) >= range_; }

// While active the result stays as it was when the value was reached (CNT-HYST-01). `reaches`: the
// comparison value itself.
bool Comparator::filtered(std::int32_t count, bool condition, bool reaches) {
  if (active_ && left(count)) active_ = false;
  const bool begins = condition && !before_ && distance(count, value) < hysteresis;
  if (!active_ && hysteresis > 1 && (reaches || begins)) {
    active_ = true;
    range_ = hysteresis;
    result_ = true;
  } else if (!active_) {
    result_ = condition;
  }
  before_ = condition;
  return result_;
}

// A pulse of a length: one when the value is reached, one more when the range is left against the
// direction of then (CNT-HYST-05).
bool Comparator::trigger(std::int32_t count, int direction) {
  if (active_ && left(count)) {
    active_ = false;
    return main_ == io::CountDirection::None && direction != storedDirection_;
  }
  if (active_ || !condition(count, direction)) return false;
  if (hysteresis > 1) {
    active_ = true;
    range_ = hysteresis;
    storedDirection_ = direction;
  }
  return true;
}

void Comparator::turn(bool on, Source source) {
  on_ = on;
  source_ = on ? source : Source::None;
  reached_ = reached_ || on_;
}

// The output follows the comparison unless SET_DO has put it on (CNT-CMP-08).
bool Comparator::follow(bool result) {
  const bool responds = result && !on_;
  if (source_ != Source::Set) turn(result, Source::Comparison);
  return responds;
}

bool Comparator::step(std::int32_t count, int direction, Instant at) {
  fresh_ = false;
  if (output_ == io::CountOutput::None) return meets(count);
  const bool pulse = output_ == io::CountOutput::Pulse;
  if (pulse && duration > 0) {
    if (!trigger(count, direction)) return false;
    if (on_) return true;  // never longer, never queued (CNT-CMP-12)
    turn(true, Source::Comparison);
    pulseEnd_ = at + Duration::milliseconds(duration);
    return true;
  }
  const bool holds = condition(count, direction), before = result_;
  const bool result = filtered(count, holds, pulse ? holds : count == value);
  follow(result);
  if (pulse && source_ == Source::Set && count != value) turn(false, Source::None);
  return result && !before;
}

// Without an output: the count reaches the value, and nothing is switched.
bool Comparator::meets(std::int32_t count) {
  const bool before = result_, holds = count == value;
  return filtered(count, holds, holds) && !before;
}

// A value that was written starts no pulse, it can only end one without duration (CNT-CMP-17).
bool Comparator::look(std::int32_t count) {
  fresh_ = true;
  if (output_ == io::CountOutput::None) {
    if (count != value) meets(count);
    return false;
  }
  const bool before = result_;
  if (output_ != io::CountOutput::Pulse)
    follow(filtered(count, condition(count, 0), count == value));
  else if (duration == 0 && count != value && (!active_ || left(count)))
    follow(filtered(count, false, false));
  return result_ && !before;
}

// CNT-HYST-10
void Comparator::write(std::int32_t comparison, std::int32_t) {
  value = comparison;
  active_ = false;
  before_ = false;
}

void Comparator::control(bool enable, bool set, std::int32_t count, Instant now) {
  const bool rises = set && !set_, falls = !set && set_;
  enabled_ = enable;
  set_ = set;
  if (output_ == io::CountOutput::None) return;
  const bool pulse = output_ == io::CountOutput::Pulse;
  if (rises && !on_ && (!pulse || duration > 0 || count == value)) {
    turn(true, Source::Set);
    if (pulse && duration > 0) pulseEnd_ = now + Duration::milliseconds(duration);
  }
  if (falls) {
    turn(false, Source::None);
    pulseEnd_ = Instant::never();
  }
  fresh_ = fresh_ || rises || falls;
}

void Comparator::endPulse() {
  pulseEnd_ = Instant::never();
  turn(false, Source::None);
}

void Comparator::stop() {
  pulseEnd_ = Instant::never();
  enabled_ = set_ = on_ = false;
  source_ = Source::None;
}

std::uint64_t Comparator::absorbs(std::int32_t count, int direction) const {
  if (fresh_) return 0;
  const std::array<std::int64_t, 5> places{std::int64_t{value} - 1, value, std::int64_t{value} + 1,
                                           std::int64_t{value} - range_,
                                           std::int64_t{value} + range_};
  std::uint64_t least = kUnlimited;
  for (const std::int64_t place : places) {
    const std::int64_t ahead = (place - count) * direction;
    if (ahead > 0) least = std::min(least, static_cast<std::uint64_t>(ahead - 1));
  }
  return least;
}

}  // namespace merker::technology
