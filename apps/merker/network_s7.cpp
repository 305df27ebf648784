#include "network_s7.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "command.h"
#include "network_routes.h"

namespace merker::app {
namespace {

int s7Refused(const std::string& command, const std::string& reason) {
  std::cerr << command << ": " << reason << '\n';
  return kUsage;
}

// Of the station `number`; port 0 is any free one for each.
S7Option placeOf(const S7Place& first, std::size_t number) {
  const bool six = first.address.find(':') != std::string::npos;
  return {fmt::format("{}{}{}:{}", six ? "[" : "", first.address, six ? "]" : "",
                      first.port == 0 ? 0 : first.port + number)};
}

}  // namespace

int NetworkS7::serve(const std::string& command, const S7Option& option,
                     const compilation::NamedBuild& one, controller::Controller& plc,
                     const std::function<void()>& wake) {
  const project::Project& own = one.build->project;
  Served& served =
      served_.emplace_back(plc, monitor::monitorOf(plc, own.symbols, one.build->resolver()));
  if (const int bad = served.desk.open(command, option, own.communication, wake, one.name))
    return bad;
  plc.onCycle(served.desk.cycleObserver(*served.monitor));
  return kGood;
}

int NetworkS7::open(const std::string& command, const S7Option& option,
                    const compilation::NetworkBuild& build, network::Network& network,
                    const std::function<void()>& wake) {
  if (option.place.empty()) return kGood;
  std::string reason;
  const auto first = s7Place(option, reason);
  if (!first) return s7Refused(command, reason);
  if (network.size() > kMostServed)
    return s7Refused(
        command,
        fmt::format("--s7 serves at most {} stations; --station NAME serves one", kMostServed));
  constexpr std::size_t kHighestPort = 65'535;
  if (first->port + network.size() - 1 > kHighestPort)
    return s7Refused(command, fmt::format("--s7: each of the {} stations has a port, the first one "
                                          "must be at most {}",
                                          network.size(), kHighestPort + 1 - network.size()));
  for (std::size_t i = 0; i < network.size(); ++i)
    if (const int bad =
            serve(command, placeOf(*first, i), build.stations[i], network.itself(i), wake))
      return bad;
  route(build);
  return kGood;
}

void NetworkS7::route(const compilation::NetworkBuild& build) {
  constexpr unsigned kSlots = 32;
  std::map<std::uint8_t, S7Server*> others;
  S7Server& first = served_.front().desk.server();
  for (const auto& [address, station] : routesOf(*build.project.network)) {
    others[address] = &served_[station].desk.server();
    std::cerr << fmt::format("{} at {}, too: rack {}, slot {} (address {})\n",
                             build.stations[station].name, first.place(), address / kSlots,
                             address % kSlots, address);
  }
  if (!others.empty()) first.passOn(std::move(others));
}

void NetworkS7::look() {
  for (Served& one : served_) one.desk.exchange(*one.monitor);
}

bool NetworkS7::waits() const {
  return std::ranges::any_of(served_, [](const Served& one) { return one.desk.waits(); });
}

NetworkS7::~NetworkS7() {
  for (Served& one : served_) one.plc.onCycle({});
}

}  // namespace merker::app
