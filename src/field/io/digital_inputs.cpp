#include "io/digital_inputs.h"

#include <algorithm>
#include <utility>

namespace merker::io {
namespace {

// Only where each edge may be an interrupt is a signal followed edge by edge.
bool follows(const Parameters& parameters, std::uint32_t channel) {
  return ((parameters.risingEdges | parameters.fallingEdges) >> channel & 1) != 0;
}

}  // namespace

bool DigitalInputs::change(std::uint32_t channel, bool level, Instant now, Duration delay) {
  if (this->level(channel) == level) return false;
  const std::uint32_t bit = 1u << channel;
  levels_ ^= bit;
  const bool same = ((delivered_ & bit) != 0) == level;
  due_[channel] = same ? Instant::never() : now + delay;
  return true;
}

std::uint32_t DigitalInputs::deliver(std::uint32_t levels, const Parameters& parameters) {
  const std::uint32_t rising = levels & ~delivered_ & parameters.risingEdges;
  const std::uint32_t falling = ~levels & delivered_ & parameters.fallingEdges;
  delivered_ = levels;
  return rising | falling;
}

void DigitalInputs::attach(std::uint32_t channel, std::shared_ptr<const signal::Signal> signal,
                           Instant now) {
  signals_[channel] = {std::move(signal), now, now};
}

Instant DigitalInputs::next(const Parameters& parameters) const {
  Instant next = *std::ranges::min_element(due_);
  for (const auto& [channel, attached] : signals_)
    if (follows(parameters, channel)) next = std::min(next, attached.signal->next(attached.seen));
  return next;
}

std::optional<std::uint32_t> DigitalInputs::advance(Instant at, const Parameters& parameters) {
  std::uint32_t passed = 0;
  for (std::uint32_t c = 0; c < due_.size(); ++c) {
    if (due_[c] > at) continue;
    due_[c] = Instant::never();
    passed |= 1u << c;
  }
  for (auto& [channel, attached] : signals_) {
    if (!follows(parameters, channel)) continue;
    attached.seen = at;
    change(channel, attached.signal->level(at), at, parameters.inputDelay);
  }
  return passed != 0 ? std::optional(passing(passed)) : std::nullopt;
}

// The level that last lasted for the delay, looking back from `now`; `otherwise` if none did since
// the signal lies there.
bool DigitalInputs::settled(const Attached& attached, Duration delay, Instant now, bool otherwise) {
  constexpr int kMost = 64;  // signals without rhythm: enough
  const signal::Signal& signal = *attached.signal;
  Instant end = now, at = now;
  for (int i = 0; i < kMost; ++i) {
    const Instant begin = std::max(signal.last(at), attached.since);
    if (end - begin >= delay) return signal.level(begin);
    if (begin == attached.since) return otherwise;
    end = begin;
    at = begin - Duration{1};
  }
  return otherwise;
}

std::optional<std::uint32_t> DigitalInputs::settle(Instant now, const Parameters& parameters) {
  std::uint32_t delivered = delivered_;
  for (const auto& [channel, attached] : signals_) {
    if (follows(parameters, channel)) continue;
    const std::uint32_t bit = 1u << channel;
    const bool passed = settled(attached, parameters.inputDelay, now, (delivered_ & bit) != 0);
    delivered = passed ? delivered | bit : delivered & ~bit;
    levels_ = attached.signal->level(now) ? levels_ | bit : levels_ & ~bit;
    skipDelay(channel);
  }
  return delivered != delivered_ ? std::optional(delivered) : std::nullopt;
}

}  // namespace merker::io
