#include "system/send_receive_link.h"

#include <utility>

#include "base/bytes.h"

namespace merker::system {
namespace {

// A CP that does not answer for so long is gone; then it is called again (docs/compatibility.md).
constexpr Duration kCpPatience = Duration::seconds(2), kCpPause = Duration::seconds(1);

}  // namespace

void SendReceiveLink::send(CpMessage message, Instant now, View octets) {
  std::vector<std::uint8_t> data = {static_cast<std::uint8_t>(message)};
  appendWord(data, end_.number);
  data.insert(data.end(), octets.begin(), octets.end());
  end_.node->send(now, end_.partner, std::move(data));
}

void SendReceiveLink::open(SendReceive& program) {
  state_ = State::Up;
  SendReceive::connected(program.at(place_), true);
}

void SendReceiveLink::close(SendReceive& program, Instant now) {
  SendReceive::connected(program.at(place_), false);
  state_ = State::Idle;
  due_ = now + kCpPause;
}

void SendReceiveLink::fall(SendReceive& program) {
  close(program, Instant());
  due_ = Instant::never();
}

Instant SendReceiveLink::next() const {
  const bool calls = state_ == State::Idle && (end_.active || datagrams());
  return calls || state_ == State::Calling || state_ == State::Waiting ? due_ : Instant::never();
}

void SendReceiveLink::move(SendReceive& program, Instant now) {
  if (next() > now) return;
  if (datagrams()) return open(program);
  if (state_ != State::Idle) {
    send(CpMessage::End, now);
    return close(program, now);
  }
  state_ = State::Calling;
  due_ = now + kCpPatience;
  send(CpMessage::Connect, now);
}

void SendReceiveLink::exchange(SendReceive& program, Instant now) {
  SendReceive::Connection& one = program.at(place_);
  if (state_ != State::Up || !one.out) return;
  const SendReceive::Bytes data = *std::exchange(one.out, std::nullopt);
  send(CpMessage::Data, now, data);
  if (datagrams()) return SendReceive::ended(one, SendReceive::kSent);
  state_ = State::Waiting;
  due_ = now + kCpPatience;
}

// The CP has its own store: it takes data in STOP, too.
void SendReceiveLink::take(View octets, SendReceive& program, Instant now) {
  if (state_ != State::Up && state_ != State::Waiting) {
    if (!datagrams()) send(CpMessage::End, now);
    return;
  }
  const bool taken =
      SendReceive::arrived(program.at(place_), SendReceive::Bytes(octets.begin(), octets.end()));
  if (!datagrams()) send(taken ? CpMessage::Taken : CpMessage::Full, now);
}

void SendReceiveLink::finish(std::uint16_t result, SendReceive& program) {
  if (state_ != State::Waiting) return;
  state_ = State::Up;
  SendReceive::ended(program.at(place_), result);
}

void SendReceiveLink::hear(CpMessage message, View octets, SendReceive& program, Instant now) {
  switch (message) {
    case CpMessage::Connect:
      if (end_.active || datagrams()) return;
      if (state_ != State::Idle) close(program, now);  // the partner has begun anew
      open(program);
      return send(CpMessage::Accept, now);
    case CpMessage::Accept:
      return state_ == State::Calling ? open(program) : void();
    case CpMessage::Data:
      return take(octets, program, now);
    case CpMessage::Taken:
      return finish(SendReceive::kSent, program);
    case CpMessage::Full:
      return finish(SendReceive::kNotTaken, program);
    case CpMessage::End:
      return state_ == State::Idle || datagrams() ? void() : close(program, now);
  }
}

}  // namespace merker::system
