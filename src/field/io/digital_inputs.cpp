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
  setDue(channel, same ? Instant::never() : now + delay);
  return true;
}

void DigitalInputs::setDue(std::uint32_t channel, Instant due) {
  if (due_[channel] == due) return;
  due_[channel] = due;
  soonest_ = *std::ranges::min_element(due_);
}

std::uint32_t DigitalInputs::deliver(std::uint32_t levels, const Parameters& parameters) {
  const std::uint32_t rising = levels & ~delivered_ & parameters.risingEdges;
  const std::uint32_t falling = ~levels & delivered_ & parameters.fallingEdges;
  delivered_ = levels;
  return rising | falling;
}

void DigitalInputs::attach(std::uint32_t channel, std::shared_ptr<const signal::Signal> signal,
                           Instant now, Instant held) {
  signals_[channel] = {std::move(signal), now, now, held};
}

Instant DigitalInputs::heldSince(std::uint32_t channel, Instant now) const {
  const auto found = signals_.find(channel);
  if (found == signals_.end()) return now;
  const Attached& attached = found->second;
  const Instant last = attached.signal->last(now);
  return last > attached.since ? last : attached.held;
}

Instant DigitalInputs::next(const Parameters& parameters) const {
  Instant next = soonest_;
  for (const auto& [channel, attached] : signals_)
    if (follows(parameters, channel)) next = std::min(next, attached.signal->next(attached.seen));
  return next;
}

std::optional<std::uint32_t> DigitalInputs::advance(Instant at, const Parameters& parameters) {
  std::uint32_t passed = 0;
  for (std::uint32_t c = 0; soonest_ <= at && c < due_.size(); ++c) {
    if (due_[c] > at) continue;
    setDue(c, Instant::never());
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
  if (signal.neverLasts(delay, attached.since, now)) return otherwise;
  Instant end = now, at = now;
  for (int i = 0; i < kMost; ++i) {
    const Instant last = signal.last(at);
    const bool first = last <= attached.since;
    if (end - (first ? attached.held : last) >= delay)
      return signal.level(first ? attached.since : last);
    if (first) return otherwise;
    end = last;
    at = last - Duration{1};
  }
  return otherwise;
}

// What is delivered with this channel as it is then.
std::uint32_t DigitalInputs::settled(std::uint32_t channel, Attached& attached, Instant now,
                                     const Parameters& parameters) {
  if (follows(parameters, channel)) return delivered_;
  const std::uint32_t bit = 1u << channel;
  const bool passed = settled(attached, parameters.inputDelay, now, (delivered_ & bit) != 0);
  levels_ = attached.signal->level(now) ? levels_ | bit : levels_ & ~bit;
  skipDelay(channel);
  return passed ? delivered_ | bit : delivered_ & ~bit;
}

std::optional<std::uint32_t> DigitalInputs::settle(Instant now, const Parameters& parameters) {
  std::uint32_t delivered = delivered_;
  for (auto& [channel, attached] : signals_) {
    const std::uint32_t bit = 1u << channel;
    delivered = (delivered & ~bit) | (settled(channel, attached, now, parameters) & bit);
  }
  return delivered != delivered_ ? std::optional(delivered) : std::nullopt;
}

std::optional<std::uint32_t> DigitalInputs::settle(std::uint32_t channel, Instant now,
                                                   const Parameters& parameters) {
  const auto found = signals_.find(channel);
  if (found == signals_.end()) return std::nullopt;
  const std::uint32_t delivered = settled(channel, found->second, now, parameters);
  return delivered != delivered_ ? std::optional(delivered) : std::nullopt;
}

}  // namespace merker::io
