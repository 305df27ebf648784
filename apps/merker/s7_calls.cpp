#include "s7_calls.h"

#include <fmt/format.h>

#include <boost/asio/ip/address.hpp>

#include "server/guard.h"

namespace merker::app {
namespace {

// Between two calls of a partner that does not answer, or has gone.
constexpr std::chrono::seconds kBetweenCalls(1);

}  // namespace

bool S7Calls::mayCall(const ConnectionParameters& parameters) const {
  return parameters.active && (outside_ || hmi::isLocalAddress(parameters.host));
}

void S7Calls::look(S7Connection::Clock::time_point now, const Take& take) {
  served::Partners& partners = around_.exchange.partners();
  calls_.resize(partners.count());
  for (std::size_t i = 0; i < calls_.size(); ++i) {
    const ConnectionParameters& parameters = partners.parameters(i);
    const auto running = calls_[i].running.lock();
    if (!mayCall(parameters) || now < calls_[i].next || (running && !running->closed())) continue;
    boost::system::error_code wrong;
    const auto address = boost::asio::ip::make_address(parameters.host, wrong);
    if (wrong) continue;
    auto call = std::make_shared<S7Connection>(S7Connection::Socket(context_), around_, i);
    calls_[i] = {call, now + kBetweenCalls};
    call->call({address, parameters.port});
    take(std::move(call));
  }
}

std::vector<workbench::S7PartnerRow> S7Calls::rows() const {
  served::Partners& partners = around_.exchange.partners();
  std::vector<workbench::S7PartnerRow> rows;
  for (std::size_t i = 0; i < partners.count(); ++i) {
    const ConnectionParameters& one = partners.parameters(i);
    const s7comm::Partner& partner = partners.partner(i);
    const char* const state = partner.isConnected() ? "connected"
                              : !one.active         ? "waits"
                              : mayCall(one)        ? "calls"
                                                    : "outside";
    rows.push_back({fmt::format("W#16#{:X}", one.id), one.host, one.active ? one.port : 0u,
                    one.active, state, partner.pdu()});
  }
  return rows;
}

}  // namespace merker::app
