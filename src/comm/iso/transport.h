// One transport connection over TCP, of the side that calls or of the one that is called: bytes in,
// what they mean out. Nothing waits here and nothing is sent; who owns the socket does both.
#pragma once

#include <optional>

#include "iso/tpdu.h"

namespace merker::iso {

// What came.
struct Event {
  enum class Kind : std::uint8_t {
    Requested,     // somebody calls: confirm() or refuse()
    Confirmed,     // who was called has answered
    Message,       // whole, of all its parts
    Disconnected,  // `reason`; the TCP connection is to be closed
    Violated       // the other side breaks the protocol, `why`: send `answer`, close
  };
  Kind kind = Kind::Message;
  ConnectParameters parameters{};
  Bytes message{};
  std::uint8_t reason = 0;
  std::string_view why{};
  Bytes answer{};
};

class Transport {
 public:
  enum class Side : std::uint8_t { Calling, Called };
  static constexpr std::size_t kMostMessage = 1 << 20;  // octets of all parts together
  static constexpr std::size_t kMostParts = 10'000;  // empty ones are sent by programming devices

  explicit Transport(Side side) : side_(side) {}

  // From TCP, cut anywhere. Not after the connection has ended.
  void feed(View bytes);
  // What the bytes so far mean, one after the other.
  std::optional<Event> next();
  // Octets that wait for next().
  std::size_t waiting() const { return buffer_.size() - read_; }
  // A packet or a message has begun and not ended: what follows must come in time.
  bool unfinished() const { return waiting() > 0 || !message_.empty(); }
  bool open() const { return state_ == State::Open; }

  // To send. The called side, after Requested:
  Bytes confirm();
  Bytes refuse(Reason reason);
  // The calling side, first of all:
  Bytes request(ConnectParameters parameters);
  // A message, in as many parts as the agreed size asks for.
  void write(Bytes& out, View message) const;
  // Ends an open connection; TCP is closed behind it.
  Bytes disconnect(Reason reason);

 private:
  enum class State : std::uint8_t { Idle, Asked, Open, Ended };

  std::optional<Event> take(const Tpdu& tpdu);
  std::optional<Event> takeData(const Tpdu& tpdu);
  Event takeRequest(const Tpdu& tpdu);
  Event takeConfirm(const Tpdu& tpdu);
  Event violated(std::string_view why, Reason reason = Reason::ProtocolError);
  void agree(const ConnectParameters& parameters);

  Side side_;
  State state_ = State::Idle;
  Bytes buffer_, message_;
  std::size_t read_ = 0;               // of buffer_
  std::size_t parts_ = 0;              // of message_
  std::uint16_t own_ = 1, other_ = 0;  // references
  ConnectParameters asked_;
  std::size_t tpduSize_ = kMostPacket - kTpktHeader;
};

}  // namespace merker::iso
