// Configured connections between the two threads: what the program has ordered goes to the partners
// at an end of a cycle, what they bring comes to it at the next one. Nobody waits for the other.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "catalogue/communication.h"
#include "monitor/monitor.h"
#include "s7comm/partner.h"

namespace merker::served {

class Partners {
 public:
  using Call = std::function<void()>;
  ~Partners();

  // As Exchange::connectBy.
  void connectBy(std::function<void(Call)> post, Call wake);

  // In the thread of the connections. Those that there were are detached.
  void configure(const std::vector<ConnectionParameters>& connections);
  std::size_t count() const { return ends_.size(); }
  const ConnectionParameters& parameters(std::size_t connection) const;
  s7comm::Partner& partner(std::size_t connection);

  // In the thread of the PLC.
  void exchange(controller::Controller& plc);
  // Another PLC is there from now on; configure() comes for it.
  void forget();

 private:
  // A connection; the program, as its partner meets it.
  struct End final : s7comm::PartnerProgram {
    End(Partners& all, ConnectionParameters of) : owner(all), parameters(std::move(of)) {}
    void connected(bool is) override;
    void finished(s7comm::PartnerResult result) override;
    void begun(std::uint32_t rid, std::size_t octets) override;
    void arrived(s7comm::Telegram telegram) override;
    void noticed(s7comm::Notice notice) override;

    Partners& owner;
    ConnectionParameters parameters;
    s7comm::Partner partner{*this};
    s7comm::FromPartner news{};  // for the next end of a cycle
    s7comm::ToPartner orders{};  // of the last ones
  };
  template <class Change>
  void tell(const Change& change);
  void carry();

  std::function<void(Call)> post_ = [](const Call& call) { call(); };
  Call wake_ = [] {};
  std::mutex mutex_;                        // of news and orders, and which ends there are
  std::vector<std::unique_ptr<End>> ends_;  // changed by the thread of the connections
  bool stale_ = false;                      // they belong to a PLC that has gone
};

}  // namespace merker::served
