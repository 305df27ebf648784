// The receiving half of the ASCII driver (PTP-ASCII-11 to -26, -37).
#include <utility>

#include "serial/ascii.h"

namespace merker::serial {
namespace {

Event eventOf(const Character& c) {
  if ((c.faults & Character::kOverrun) != 0) return Event::Transmission;
  return (c.faults & Character::kFrame) != 0 ? Event::FrameError : Event::ParityError;
}

}  // namespace

void Ascii::start(Instant) {
  if (parameters_.flowControl) pending_.push_back(parameters_.xon);  // PTP-ASCII-28
}

void Ascii::fetched() { adjustFlow(); }

// A running job ends; the telegram that is arriving is lost with the reaction STOP, unless the
// partner can be held (PTP-PARAM-02 to -06).
void Ascii::cpuStopped() {
  stopped_ = true;
  abort(Event::Restarted);
  if (parameters_.discardInStop && !parameters_.flowControl) mailbox_.refuse(true);
  adjustFlow();
}

void Ascii::cpuStarted() {
  stopped_ = false;
  mailbox_.start();
  adjustFlow();
}

// A telegram with a fault is read to its end, discarded and reported (PTP-ASCII-21).
void Ascii::note(Event event) {
  if (fault_ == Event::None) fault_ = event;
}

void Ascii::interrupted(Instant) {
  forget();
  mailbox_.report(Event::Break);
}

void Ascii::forget() {
  reader_ = Reader::Idle;
  data_.clear();
  marks_ = 0;
  fault_ = Event::None;
  quietAt_ = Instant::never();
}

void Ascii::received(const Character& c) {
  if (flow(c)) return;
  quietAt_ = c.at + parameters_.delay;
  store(c);
  if (reader_ != Reader::Skip) look();
  adjustFlow();
}

// Beyond 1024 bytes, or beyond the buffer behind XOFF, the rest is read and thrown away.
void Ascii::store(const Character& c) {
  if (!c.good()) note(eventOf(c));
  if (reader_ == Reader::Skip) return;
  const bool overflow =
      parameters_.flowControl && mailbox_.bytes() + data_.size() == Mailbox::kSize;
  if (data_.size() == kLongest || overflow) {
    note(overflow ? Event::AfterXoff : Event::ReceivedTooLong);
    reader_ = Reader::Skip;
    data_.clear();
    return;
  }
  data_.push_back(c.value);
  marks_ = c.good() ? marks_ + 1 : 0;
}

// The last characters are the end mark, received without fault.
bool Ascii::endMark() const {
  if (marks_ < parameters_.endCharacters) return false;
  if (parameters_.endCharacters == 1) return data_.back() == parameters_.end1;
  return data_.size() > 1 && data_[data_.size() - 2] == parameters_.end1 &&
         data_.back() == parameters_.end2;
}

bool Ascii::complete() const {
  using End = AsciiParameters::End;
  if (parameters_.end == End::Count) return data_.size() == parameters_.length;
  return parameters_.end == End::Characters && endMark();
}

void Ascii::look() {
  if (reader_ == Reader::Check) {
    if (--checksLeft_ == 0) deliver();
    return;
  }
  reader_ = Reader::Receive;
  if (!complete()) return;
  const bool checks = parameters_.end == AsciiParameters::End::Characters;
  checksLeft_ = checks ? parameters_.checkCharacters : 0U;
  if (checksLeft_ == 0) return deliver();
  reader_ = Reader::Check;
}

// ZVZ is over: the end of the telegram, or its end mark is missing.
void Ascii::quiet() {
  if (parameters_.end != AsciiParameters::End::Delay) note(Event::CharacterDelay);
  deliver();
}

void Ascii::deliver() {
  Bytes telegram = std::exchange(data_, {});
  const Event fault = fault_;
  forget();
  if (fault != Event::None) return mailbox_.report(fault);
  const Event refused = mailbox_.put(std::move(telegram));
  if (refused == Event::None) return adjustFlow();
  mailbox_.report(parameters_.flowControl && !stopped_ ? Event::AfterXoff : refused);
}

}  // namespace merker::serial
