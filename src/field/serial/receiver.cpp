#include "serial/receiver.h"

#include <algorithm>

namespace merker::serial {

Receiver::Receiver(const Wire& wire, const Settings& settings)
    : wire_(wire),
      frame_(settings.frame),
      baud_(settings.baud),
      preset_(settings.preset),
      length_(characterTime(settings.frame, settings.baud)) {
  for (unsigned bit = 0; bit < samples_.size(); ++bit)
    samples_[bit] = {(bitTime(bit, baud_).ns + bitTime(bit + 1, baud_).ns) / 2};
}

// An open line has the level of the preset: R(A) 5 V / R(B) 0 V is the level of a start bit, which
// is how a BREAK is recognised (PTP-PHY-17). Without a preset it stays idle.
bool Receiver::level(Instant t) const {
  const bool undriven = preset_ != Preset::Break;
  return (cut_ ? undriven : wire_.level(t, undriven)) != swapped_;
}

Instant Receiver::find(bool wanted, Instant from) const {
  Instant t = from;
  while (t != Instant::never() && level(t) != wanted)
    t = cut_ ? Instant::never() : wire_.boundaryAfter(t);
  return t;
}

Instant Receiver::startBit() const {
  const Instant idle = needsIdle_ ? find(true, from_) : from_;
  return idle == Instant::never() ? idle : find(false, idle);
}

void Receiver::begin(Instant at) {
  state_ = State::Receiving;
  start_ = needs_ = at;
  sampled_ = 0;
  bits_ = 0;
}

void Receiver::search(Instant from, bool needsIdle) {
  state_ = State::Searching;
  from_ = needs_ = from;
  needsIdle_ = needsIdle;
}

// A character that is alone on the wire, with the rate of this receiver: the bits that sampling
// would find.
bool Receiver::takeWhole(Instant until) {
  if (sampled_ > 0 || cut_ || swapped_ || until <= lastSample()) return false;
  const auto bits = wire_.alone(start_, baud_, frame_.bits());
  if (!bits) return false;
  bits_ = *bits;
  sampled_ = frame_.bits();
  needs_ = lastSample();
  return true;
}

// A start bit that is over before its middle was a disturbance.
void Receiver::sample(Instant until) {
  if (takeWhole(until)) return;
  while (sampled_ < frame_.bits() && sampleTime(sampled_) < until) {
    needs_ = sampleTime(sampled_);
    if (level(needs_)) bits_ = static_cast<std::uint16_t>(bits_ | 1U << sampled_);
    ++sampled_;
    if ((bits_ & 1U) != 0) return search(needs_, false);
  }
}

void Receiver::observe(Instant now) {
  while (true) {
    if (state_ == State::Receiving) sample(now);
    if (state_ == State::Interrupted && find(true, from_) > now)
      from_ = needs_ = std::max(from_, now);
    if (state_ != State::Searching) return;
    const Instant at = startBit();
    if (at >= now) break;
    begin(at);
  }
  if (needsIdle_ && find(true, from_) < now) needsIdle_ = false;
  from_ = needs_ = std::max(from_, now);
}

Instant Receiver::next() const {
  if (state_ == State::Receiving) return end();
  if (state_ == State::Interrupted) return find(true, from_);
  const Instant at = startBit();
  return at == Instant::never() ? at : at + length_;
}

// BREAK: the level of a start bit for longer than a whole character (PTP-DIAG-10). With another
// preset it is a character with a wrong stop bit.
Receiver::Event Receiver::complete(Instant now) {
  const Decoded decoded = decode(frame_, bits_);
  if (bits_ == 0 && preset_ == Preset::Break && !level(now)) {
    state_ = State::Interrupted;
    from_ = needs_ = now;
    return {Event::Kind::Interrupted, {.at = now}};
  }
  Character c{.value = decoded.value, .at = now};
  if (decoded.parityFault) c.faults |= Character::kParity;
  if (decoded.frameFault || wire_.collided(start_, now)) c.faults |= Character::kFrame;
  if (wire_.overrun(start_, now)) c.faults |= Character::kOverrun;
  // A low line behind a wrong stop bit is the next start bit, unless it was low all the time. Its
  // middle is the end of this character: behind it, however both were rounded.
  constexpr Duration kRounding{2};
  search(lastSample() + (decoded.frameFault ? kRounding : Duration{}), bits_ == 0);
  return {Event::Kind::Character, c};
}

std::optional<Receiver::Event> Receiver::take(Instant now) {
  if (state_ == State::Interrupted) {
    if (find(true, from_) > now) return std::nullopt;
    search(now, false);
    return Event{Event::Kind::Restored, {.at = now}};
  }
  if (state_ == State::Searching) observe(now);
  if (state_ == State::Receiving) sample(now);
  if (state_ != State::Receiving || end() > now) return std::nullopt;
  return complete(now);
}

void Receiver::mute(Instant until) { search(until, true); }

}  // namespace merker::serial
