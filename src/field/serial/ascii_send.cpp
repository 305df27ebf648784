// The sending half of the ASCII driver and the flow control of both (PTP-ASCII-03 to -10, -28 to
// -33, -36).
#include <algorithm>

#include "serial/ascii.h"

namespace merker::serial {
namespace {

// Where the first end mark ends; 0: there is none.
std::size_t behindEnd(const Bytes& data, const AsciiParameters& parameters) {
  const Bytes mark = parameters.endCharacters == 2 ? Bytes{parameters.end1, parameters.end2}
                                                   : Bytes{parameters.end1};
  const auto at = std::search(data.begin(), data.end(), mark.begin(), mark.end());
  return at == data.end() ? 0 : static_cast<std::size_t>(at - data.begin()) + mark.size();
}

}  // namespace

// What is on the line of a job; nothing if it has no end mark or becomes too long.
std::optional<Bytes> Ascii::telegramOf(const Bytes& data) const {
  using Sending = AsciiParameters::Sending;
  Bytes telegram = data;
  if (parameters_.end == AsciiParameters::End::Characters) {
    if (parameters_.sending == Sending::UpToEnd) telegram.resize(behindEnd(data, parameters_));
    if (parameters_.sending == Sending::Append) {
      telegram.push_back(parameters_.end1);
      if (parameters_.endCharacters == 2) telegram.push_back(parameters_.end2);
    }
  }
  if (telegram.empty() || telegram.size() > kLongest) return std::nullopt;
  return telegram;
}

void Ascii::send(const Bytes& data, Instant now) {
  outbox_.begin();
  auto telegram = telegramOf(data);
  if (!telegram) return outbox_.end(Event::WrongLength);
  telegram_ = std::move(*telegram);
  index_ = 0;
  ready_ = now + parameters_.preparation.of(data.size());
  sender_ = Sender::Waiting;
}

void Ascii::abort(Event why) {
  if (outbox_.busy()) end(why);
}

void Ascii::end(Event event) {
  sender_ = Sender::Idle;
  xonUntil_ = Instant::never();
  outbox_.end(event);
}

// The pause behind the last telegram has passed, and over two wires nobody else is sending.
Instant Ascii::mayBegin() const {
  if (parameters_.twoWire && reader_ != Reader::Idle) return Instant::never();
  return std::max(ready_, pauseUntil_);
}

void Ascii::begin(Instant now) {
  sender_ = Sender::Sending;
  if (xoffReceived_) hold(now);
}

void Ascii::hold(Instant now) {
  sender_ = Sender::Held;
  xonUntil_ = now + parameters_.xonWait;
}

// XON and XOFF of the partner; never part of the data (PTP-ASCII-32, -33).
bool Ascii::flow(const Character& c) {
  if (!parameters_.flowControl) return false;
  if (c.is(parameters_.xoff)) {
    xoffReceived_ = true;
    if (sender_ == Sender::Sending && index_ < telegram_.size()) hold(c.at);
  } else if (c.is(parameters_.xon)) {
    xoffReceived_ = false;
    xonUntil_ = Instant::never();
    if (sender_ == Sender::Held) sender_ = Sender::Sending;
  } else {
    return false;
  }
  return true;
}

std::optional<std::uint8_t> Ascii::next(Instant) {
  leaving_ = false;
  if (!pending_.empty()) {
    const std::uint8_t value = pending_.front();
    pending_.erase(pending_.begin());
    return value;
  }
  if (sender_ != Sender::Sending || index_ == telegram_.size()) return std::nullopt;
  leaving_ = true;
  return telegram_[index_++];
}

// The pause is longer than ZVZ with that criterion, as long as it with a fixed count
// (PTP-ASCII-04, -05).
void Ascii::sent(Instant at) {
  if (!leaving_) return;
  leaving_ = false;
  using End = AsciiParameters::End;
  if (parameters_.end == End::Delay)
    pauseUntil_ = at + parameters_.delay + Duration{1};
  else if (parameters_.end == End::Count && parameters_.pause)
    pauseUntil_ = at + parameters_.delay;
  if (sender_ == Sender::Sending && index_ == telegram_.size()) end(Event::None);
}

// 50 characters before the buffer overflows, the number of telegrams, or a CPU that takes nothing
// (PTP-ASCII-29, PTP-PARAM-06).
bool Ascii::wantsXoff() const {
  constexpr std::size_t kReserve = 50;
  return (stopped_ && parameters_.discardInStop) || mailbox_.countReached() ||
         mailbox_.bytes() + data_.size() >= Mailbox::kSize - kReserve;
}

void Ascii::adjustFlow() {
  if (!parameters_.flowControl || wantsXoff() == xoffSent_) return;
  xoffSent_ = !xoffSent_;
  pending_.push_back(xoffSent_ ? parameters_.xoff : parameters_.xon);
}

Instant Ascii::due() const {
  const Instant begins = sender_ == Sender::Waiting ? mayBegin() : Instant::never();
  return std::min({begins, xonUntil_, quietAt_});
}

void Ascii::expire(Instant now) {
  if (quietAt_ <= now) quiet();
  if (sender_ == Sender::Waiting && mayBegin() <= now) begin(now);
  if (xonUntil_ <= now) end(Event::NoXon);
}

}  // namespace merker::serial
