#include "system/subnet_link.h"

#include <utility>

#include "base/bytes.h"
#include "system/connections.h"

namespace merker::system {
namespace {

// A partner that does not answer for so long is gone; then it is called again
// (docs/compatibility.md).
constexpr Duration kLinkPatience = Duration::seconds(2), kLinkPause = Duration::seconds(1);

}  // namespace

SubnetLink::SubnetLink(const network::ConnectionEnd& end, s7comm::Plc& plc, std::uint16_t pdu)
    : end_(end), plc_(plc), pdu_(pdu) {}

void SubnetLink::arrived(s7comm::Telegram telegram) {
  news_.begun.erase(telegram.rid);
  news_.telegrams.push_back(std::move(telegram));
}

void SubnetLink::send(LinkMessage message, s7comm::View octets) {
  s7comm::Bytes data = {static_cast<std::uint8_t>(message)};
  appendWord(data, end_.number);
  data.insert(data.end(), octets.begin(), octets.end());
  end_.node->send(now_, end_.partner, std::move(data));
  deadline_ = now_ + kLinkPatience;
}

void SubnetLink::open() {
  const auto out = [this](const s7comm::Bytes& pdu) { send(LinkMessage::Data, pdu); };
  state_ = State::Up;
  partner_.attach(out);
  session_ = std::make_shared<s7comm::Session>(plc_, out, s7comm::Offer{.pdu = pdu_});
}

void SubnetLink::close() {
  if (session_) session_->end();
  session_.reset();
  partner_.detach();
  state_ = State::Idle;
  retry_ = now_ + kLinkPause;
}

void SubnetLink::fall() {
  close();
  retry_ = Instant::never();
}

void SubnetLink::lost(Instant now) {
  now_ = now;
  if (state_ != State::Idle) close();
}

Instant SubnetLink::next() const {
  if (state_ == State::Idle) return end_.active ? retry_ : Instant::never();
  return state_ == State::Calling || partner_.asks() ? deadline_ : Instant::never();
}

void SubnetLink::move(Instant now) {
  if (next() > now) return;
  now_ = now;
  if (state_ == State::Idle) {
    state_ = State::Calling;
    return send(LinkMessage::Connect);
  }
  if (state_ == State::Up) send(LinkMessage::End);
  close();
}

void SubnetLink::hear(LinkMessage message, s7comm::View octets, Instant now) {
  now_ = now;
  switch (message) {
    case LinkMessage::Connect:
      if (end_.active) return;
      if (state_ == State::Up) close();  // the partner has begun anew
      open();
      return send(LinkMessage::Accept);
    case LinkMessage::Accept:
      if (state_ != State::Calling) return;
      open();
      return partner_.setUp({.pdu = pdu_});
    case LinkMessage::Data:
      return state_ == State::Up ? takePdu(octets) : send(LinkMessage::End);
    case LinkMessage::End:
      return lost(now);
  }
}

void SubnetLink::takePdu(s7comm::View pdu) {
  deadline_ = now_ + kLinkPatience;
  if (serves(pdu)) return;
  send(LinkMessage::End);
  close();
}

// PDUs of the partner's program, and those of a client beside it. False: it breaks the protocol.
bool SubnetLink::serves(s7comm::View pdu) {
  switch (partner_.receive(pdu)) {
    case s7comm::Partner::Heard::Wrong:
      return false;
    case s7comm::Partner::Heard::Done:
      if (!session_->isSetUp()) session_->agreed(partner_.pdu());
      return true;
    case s7comm::Partner::Heard::NotMine:
      break;
  }
  if (!session_->receive(pdu)) return false;
  if (session_->isSetUp() && !partner_.isConnected()) partner_.agreed(session_->pdu());
  return true;
}

void SubnetLink::exchange(Connections& program, Instant now) {
  now_ = now;
  if (!place) return;
  program.bring(*place, std::exchange(news_, {}));
  s7comm::ToPartner orders = program.ordered(*place);
  if (!orders.empty()) partner_.order(std::move(orders));
}

}  // namespace merker::system
