#include "serial/port.h"

#include <algorithm>

namespace merker::serial {

Port::Port(std::size_t number, Driver& driver, const Settings& settings, Wire& out, const Wire& in)
    : number_(number), driver_(driver), settings_(settings), out_(out), receiver_(in, settings) {
  out_.hold(settings.mode == Mode::PointToPoint || settings.mode == Mode::MultipointMaster);
}

Instant Port::next() const {
  const Instant sent = sending_ ? busyUntil_ : Instant::never();
  return std::min({sent, receiver_.next(), driver_.due()});
}

void Port::finish(Instant now) {
  if (!sending_ || busyUntil_ > now) return;
  sending_ = false;
  driver_.sent(now);
}

void Port::receive(Instant now) {
  const auto event = receiver_.take(now);
  if (!event) return;
  switch (event->kind) {
    case Receiver::Event::Kind::Character:
      return driver_.received(event->character);
    case Receiver::Event::Kind::Interrupted:
      see(Sighting::Kind::Interrupted, now);
      return driver_.interrupted(now);
    case Receiver::Event::Kind::Restored:
      see(Sighting::Kind::Restored, now);
      return driver_.restored(now);
  }
}

void Port::run(Instant now) {
  if (driver_.due() <= now) driver_.expire(now);
  if (sending_) return;
  if (const auto value = driver_.next(now)) send(*value, now);
}

// A character that follows at once counts its bits from the same base as the one before it.
void Port::begin(Instant now) {
  if (now != busyUntil_) {
    base_ = now;
    bits_ = 0;
  }
  while (bits_ >= settings_.baud) {
    base_ = base_ + Duration::seconds(1);
    bits_ -= settings_.baud;
  }
}

Emission Port::shape(std::uint8_t value) {
  const auto found = faults_.find(index_++);
  if (found == faults_.end()) return plain(settings_.frame, value);
  const Fault fault = found->second;
  faults_.erase(found);
  return disturbed(settings_.frame, value, fault);
}

void Port::emit(std::uint16_t bits, Instant at, bool overrun) {
  const Frame& frame = settings_.frame;
  out_.put({.start = at,
            .baud = settings_.baud,
            .bits = bits,
            .count = static_cast<std::uint8_t>(frame.bits()),
            .sender = static_cast<std::uint8_t>(number_),
            .overrun = overrun});
  if (!monitor_) return;
  const Decoded seen = decode(frame, bits);
  Sighting sighting{number_, seen.value, at, at + characterTime(frame, settings_.baud)};
  if (seen.parityFault) sighting.faults |= Character::kParity;
  if (seen.frameFault) sighting.faults |= Character::kFrame;
  if (overrun) sighting.faults |= Character::kOverrun;
  monitor_(sighting);
}

// The first port hears the others, these hear the first.
void Port::see(Sighting::Kind kind, Instant now) const {
  if (!monitor_) return;
  const std::size_t far = number_ == 0 ? 1 : 0;
  monitor_({.port = far, .start = now, .end = now, .kind = kind});
}

void Port::send(std::uint8_t value, Instant now) {
  begin(now);
  const Emission emission = shape(value);
  Duration extra = emission.delay;
  const Instant start = base_ + bitTime(bits_, settings_.baud);
  if (emission.before) {
    emit(*emission.before, start + extra, false);
    extra = extra + characterTime(settings_.frame, settings_.baud);
  }
  if (emission.character) emit(*emission.character, start + extra, emission.overrun);
  finished(extra + gap_);
}

// When the next one may follow; off the grid of bit times this is a new base.
void Port::finished(Duration extra) {
  sending_ = true;
  bits_ += settings_.frame.bits();
  busyUntil_ = base_ + bitTime(bits_, settings_.baud) + extra;
  if (extra != Duration{}) {
    base_ = busyUntil_;
    bits_ = 0;
  }
  if (settings_.mode == Mode::TwoWire) receiver_.mute(busyUntil_ + kChangeOver);
}

}  // namespace merker::serial
