// Configured connections (S7-NETPRO-08) as the program has them: what its blocks want stays here
// until the end of the cycle, what partners have brought is here from an end of a cycle on. Whoever
// carries both (service/served) is not known here.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "catalogue/communication.h"
#include "s7comm/partner_job.h"

namespace merker::system {

class Connections {
 public:
  using Instance = std::uint32_t;                      // data block and byte in it
  static constexpr std::size_t kMostInstances = 1024;  // of sending and of receiving blocks each

  // A sending block: BSEND, GET, PUT, USEND.
  struct Sender {
    bool request = false, reset = false;  // as they were in the last call
    std::optional<std::uint32_t> job{};
    std::size_t connection = 0;
    std::optional<s7comm::PartnerResult> result{};
  };
  // A receiving block: BRCV, URCV.
  struct Receiver {
    std::optional<std::size_t> connection{};  // once it has been called with EN_R
    std::uint32_t rid = 0;
    bool blocks = true;  // BRCV
    bool enabled = false;
    std::size_t room = 0;   // octets of RD_1
    std::size_t begun = 0;  // octets of a telegram that is not whole
    std::deque<s7comm::Telegram> telegrams{};
    std::optional<s7comm::Notice> notice{};  // URCV
  };

  void configure(const std::vector<ConnectionParameters>& connections);
  // One more, behind them; its place.
  std::size_t add(std::uint16_t id);
  // The program begins anew.
  void restart();

  // Of the blocks. The place of a connection; nothing: there is none with this ID.
  std::optional<std::size_t> find(std::uint32_t id) const;
  bool connected(std::size_t connection) const { return connections_[connection].connected; }
  // Null: there are too many.
  Sender* sender(Instance instance);
  Receiver* receiver(Instance instance);
  void begin(Sender& sender, std::size_t connection, s7comm::PartnerJob job);
  void abort(const Sender& sender);
  // False: another one of its kind has this R_ID.
  bool bind(Receiver& receiver, std::size_t connection, std::uint32_t rid, bool blocks);
  void release(Receiver& receiver);
  void enable(Receiver& receiver, bool enabled, std::size_t room);
  // The oldest telegram; the next one may come.
  s7comm::Telegram take(Receiver& receiver);

  // Of whoever carries them, at the end of a cycle.
  std::size_t count() const { return connections_.size(); }
  s7comm::ToPartner ordered(std::size_t connection);
  void bring(std::size_t connection, s7comm::FromPartner news);

 private:
  struct Connection {
    std::uint16_t id = 0;
    bool connected = false;
    s7comm::ToPartner orders{};
  };
  void tell(std::size_t connection, const s7comm::Receiver& state);
  Receiver* receiverOf(std::size_t connection, std::uint32_t rid, bool blocks);
  void bringNotices(std::size_t connection, s7comm::FromPartner& news);

  std::vector<Connection> connections_;
  std::map<Instance, Sender> senders_;
  std::map<Instance, Receiver> receivers_;
  std::uint32_t jobs_ = 0;
};

}  // namespace merker::system
