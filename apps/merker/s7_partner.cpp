// What a connection does for the partner of a configured connection (S7-NETPRO-08): it calls, or is
// called with the TSAPs of one; PDUs of the partner go there, those of a client to the session.
#include <algorithm>

#include "s7_connection.h"

namespace merker::app {
namespace {

template <typename Octets>
bool sameTsap(const iso::Bytes& one, const Octets& other) {
  return std::ranges::equal(one, other);
}

iso::Bytes tsap(const ConnectionParameters::Tsap& octets) { return {octets.begin(), octets.end()}; }

}  // namespace

S7Connection::S7Connection(Socket socket, S7Surroundings& around, std::size_t configured)
    : socket_(std::move(socket)),
      around_(around),
      transport_(iso::Transport::Side::Calling),
      configured_(configured) {}

void S7Connection::call(const Endpoint& there) {
  expect(true);
  socket_.async_connect(there, [self = shared_from_this()](boost::system::error_code error) {
    if (self->closed_) return;
    if (error) return self->close();
    self->prepare();
    const auto& parameters = self->around_.exchange.partners().parameters(*self->configured_);
    self->out_ = self->transport_.request({.sizeCode = std::nullopt,
                                           .calling = tsap(parameters.local),
                                           .called = tsap(parameters.partner)});
    self->flush();
    self->read();
  });
}

// One that is called by its partner, and has no connection yet.
bool S7Connection::takesConfigured(const iso::ConnectParameters& parameters) {
  boost::system::error_code gone;
  const std::string host = socket_.remote_endpoint(gone).address().to_string();
  served::Partners& all = around_.exchange.partners();
  for (std::size_t i = 0; i < all.count(); ++i) {
    const ConnectionParameters& one = all.parameters(i);
    if (one.active || one.host != host || all.partner(i).attached() ||
        !sameTsap(parameters.called, one.local) || !sameTsap(parameters.calling, one.partner))
      continue;
    configured_ = i;
    return true;
  }
  return false;
}

void S7Connection::attachPartner() {
  attached_ = true;
  partner().attach([weak = weak_from_this()](const s7comm::Bytes& pdu) {
    if (const auto self = weak.lock()) self->send(pdu);
  });
}

void S7Connection::confirmed() {
  serve();
  partner().setUp({.pdu = around_.parameters.pdu});
}

bool S7Connection::partnerAsks() const {
  return around_.exchange.partners().partner(*configured_).asks();
}

bool S7Connection::hear(iso::View pdu) {
  return configured_ ? hearPartner(pdu) : session_->receive(pdu);
}

bool S7Connection::hearPartner(iso::View pdu) {
  switch (partner().receive(pdu)) {
    case s7comm::Partner::Heard::Wrong:
      return false;
    case s7comm::Partner::Heard::Done:
      if (!session_->isSetUp()) session_->agreed(partner().pdu());
      return true;
    case s7comm::Partner::Heard::NotMine:
      break;
  }
  if (!session_->receive(pdu)) return false;
  if (session_->isSetUp() && !partner().isConnected()) partner().agreed(session_->pdu());
  return true;
}

}  // namespace merker::app
