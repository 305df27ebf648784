#include "network_s7.h"

#include <algorithm>

#include "command.h"

namespace merker::app {

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
  const auto first = firstS7Place(command, option, network.size());
  if (!first) return kUsage;
  network_ = &network;
  for (std::size_t i = 0; i < network.size(); ++i)
    if (const int bad =
            serve(command, s7OptionOf(*first, i), build.stations[i], network.itself(i), wake))
      return bad;
  route(build);
  return kGood;
}

void NetworkS7::route(const compilation::NetworkBuild& build) {
  std::vector<S7Server*> servers;
  for (Served& one : served_) servers.push_back(&one.desk.server());
  ways_.lay(build, servers);
}

void NetworkS7::look() {
  if (network_ != nullptr) ways_.look(*network_);
  for (Served& one : served_) one.desk.exchange(*one.monitor);
}

bool NetworkS7::waits() const {
  return std::ranges::any_of(served_, [](const Served& one) { return one.desk.waits(); });
}

NetworkS7::~NetworkS7() {
  for (Served& one : served_) one.plc.onCycle({});
}

}  // namespace merker::app
