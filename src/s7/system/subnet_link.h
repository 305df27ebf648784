// A configured connection to another station of the project: built up over the subnet, with the
// PDUs of S7 communication on it. Its telegrams go out at the end of a cycle, or at once in STOP.
#pragma once

#include <memory>

#include "network/node.h"
#include "s7comm/partner.h"

namespace merker::system {

class Connections;

// In front of each telegram of a connection; other telegrams on MPI begin otherwise.
enum class LinkMessage : std::uint8_t { Connect = 0x50, Accept, Data, End };

class SubnetLink final : public s7comm::PartnerProgram {
 public:
  // Both outlive it. `pdu`: octets that this side offers.
  SubnetLink(const network::ConnectionEnd& end, s7comm::Plc& plc, std::uint16_t pdu);

  const network::ConnectionEnd& end() const { return end_; }
  // Where it is among the connections that blocks name.
  std::optional<std::size_t> place{};

  void hear(LinkMessage message, s7comm::View octets, Instant now);
  // The subnet could not deliver what was sent.
  void lost(Instant now);
  // What is due: calls, and partners that do not answer.
  void move(Instant now);
  // What the partner has brought, to the program; what that has ordered, to the partner.
  void exchange(Connections& program, Instant now);
  // The station is without power.
  void fall();
  void rise(Instant now) { retry_ = now; }
  // When move() is to be called.
  Instant next() const;

  void connected(bool is) override { news_.connected = is; }
  void finished(s7comm::PartnerResult result) override {
    news_.results.push_back(std::move(result));
  }
  void begun(std::uint32_t rid, std::size_t octets) override { news_.begun[rid] = octets; }
  void arrived(s7comm::Telegram telegram) override;
  void noticed(s7comm::Notice notice) override { news_.note(std::move(notice)); }

 private:
  enum class State : std::uint8_t { Idle, Calling, Up };
  void send(LinkMessage message, s7comm::View octets = {});
  void takePdu(s7comm::View pdu);
  bool serves(s7comm::View pdu);
  void open();
  void close();

  network::ConnectionEnd end_;
  s7comm::Plc& plc_;
  std::uint16_t pdu_;
  State state_ = State::Idle;
  Instant now_, retry_, deadline_;
  s7comm::Partner partner_{*this};
  std::shared_ptr<s7comm::Session> session_;  // for the partner's GET and PUT
  s7comm::FromPartner news_;
};

}  // namespace merker::system
