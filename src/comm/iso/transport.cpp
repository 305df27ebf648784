#include "iso/transport.h"

#include <algorithm>
#include <utility>

#include "base/bytes.h"

namespace merker::iso {
namespace {

// 128 … 8192 octets (RFC 905, 13.3.4 b); S7 CPUs agree on 1024 at most.
constexpr std::uint8_t kSmallest = 7, kLargest = 13, kOwn = 10;

}  // namespace

void Transport::feed(View bytes) {
  if (read_ == buffer_.size()) {
    buffer_.clear();
    read_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

Event Transport::violated(std::string_view why, Reason reason) {
  // Only who has a connection, or asks for one, has a reference to be told.
  Bytes answer;
  if (state_ == State::Asked || state_ == State::Open) answer = disconnect(reason);
  state_ = State::Ended;
  return {.kind = Event::Kind::Violated, .why = why, .answer = std::move(answer)};
}

std::optional<Event> Transport::next() {
  while (state_ != State::Ended && waiting() >= kTpktHeader) {
    const View rest = View(buffer_).subspan(read_);
    const auto length = packetLength(rest);
    if (!length) return violated("this is no TPKT of version 3");
    if (rest.size() < *length) break;
    const auto tpdu = readPacket(rest.first(*length));
    if (!tpdu) return violated(tpdu.error(), Reason::InvalidLength);
    read_ += *length;
    if (auto event = take(*tpdu)) return event;
  }
  // What is left is the beginning of a packet: it moves to the front.
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(read_));
  read_ = 0;
  return std::nullopt;
}

std::optional<Event> Transport::take(const Tpdu& tpdu) {
  switch (tpdu.kind) {
    case TpduKind::ConnectRequest:
      return takeRequest(tpdu);
    case TpduKind::ConnectConfirm:
      return takeConfirm(tpdu);
    case TpduKind::Data:
      return takeData(tpdu);
    case TpduKind::DisconnectRequest:
    case TpduKind::DisconnectConfirm:
    case TpduKind::Error:
      break;
  }
  state_ = State::Ended;
  Event event{.kind = Event::Kind::Disconnected, .reason = tpdu.reason};
  if (tpdu.kind == TpduKind::DisconnectRequest)
    writePacket(event.answer, {.kind = TpduKind::DisconnectConfirm,
                               .destination = tpdu.source,
                               .source = tpdu.destination});
  return event;
}

Event Transport::takeRequest(const Tpdu& tpdu) {
  if (side_ != Side::Called || state_ != State::Idle)
    return violated("a connection is requested a second time");
  state_ = State::Asked;
  other_ = tpdu.source;
  asked_ = tpdu.parameters;
  if (tpdu.transportClass != 0)
    return violated("only transport class 0 is supported", Reason::ClassNotSupported);
  const auto& size = asked_.sizeCode;
  if (size && (*size < kSmallest || *size > kLargest))
    return violated("the TPDU size must be 07 to 0D");
  return {.kind = Event::Kind::Requested, .parameters = asked_};
}

Event Transport::takeConfirm(const Tpdu& tpdu) {
  if (side_ != Side::Calling || state_ != State::Asked)
    return violated("nobody has asked for this confirmation");
  other_ = tpdu.source;
  const auto& size = tpdu.parameters.sizeCode;
  if (tpdu.destination != own_ || (size && (*size < kSmallest || *size > kLargest)))
    return violated("the confirmation does not fit the request");
  state_ = State::Open;
  agree(tpdu.parameters);
  return {.kind = Event::Kind::Confirmed, .parameters = tpdu.parameters};
}

// Only whole messages mean something to S7.
std::optional<Event> Transport::takeData(const Tpdu& tpdu) {
  if (state_ != State::Open) return violated("data before the connection is confirmed");
  if (tpdu.data.size() > kMostMessage - message_.size())
    return violated("a message must have at most 1 MiB");
  if (++parts_ > kMostParts) return violated("a message must have at most 10000 parts");
  message_.insert(message_.end(), tpdu.data.begin(), tpdu.data.end());
  if (!tpdu.last) return std::nullopt;
  parts_ = 0;
  return Event{.kind = Event::Kind::Message, .message = std::exchange(message_, {})};
}

// Without the parameter 65531 octets (RFC 1006, section 6).
void Transport::agree(const ConnectParameters& parameters) {
  if (parameters.sizeCode) tpduSize_ = std::size_t{1} << *parameters.sizeCode;
}

// The size goes back to whoever names one: clients that do not get it fall back to 128 octets.
Bytes Transport::confirm() {
  state_ = State::Open;
  ConnectParameters answer = asked_;
  if (answer.sizeCode) answer.sizeCode = std::min(*answer.sizeCode, kOwn);
  agree(answer);
  Bytes out;
  writePacket(out, {.kind = TpduKind::ConnectConfirm,
                    .destination = other_,
                    .source = own_,
                    .parameters = answer});
  return out;
}

Bytes Transport::refuse(Reason reason) {
  Bytes out = disconnect(reason);
  state_ = State::Ended;
  return out;
}

Bytes Transport::request(ConnectParameters parameters) {
  state_ = State::Asked;
  asked_ = std::move(parameters);
  if (!asked_.sizeCode) asked_.sizeCode = kOwn;
  Bytes out;
  writePacket(out, {.kind = TpduKind::ConnectRequest, .source = own_, .parameters = asked_});
  return out;
}

void Transport::write(Bytes& out, View message) const {
  const std::size_t most = tpduSize_ - kDataHeader;
  do {
    const std::size_t count = std::min(most, message.size());
    writeData(out, message.first(count), count == message.size());
    message = message.subspan(count);
  } while (!message.empty());
}

Bytes Transport::disconnect(Reason reason) {
  state_ = State::Ended;
  Bytes out;
  writePacket(out, {.kind = TpduKind::DisconnectRequest,
                    .destination = other_,
                    .source = own_,
                    .reason = static_cast<std::uint8_t>(reason)});
  return out;
}

}  // namespace merker::iso
