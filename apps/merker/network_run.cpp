#include "network_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "command.h"
#include "engine_option.h"
#include "network_s7.h"
#include "network_trace.h"
#include "network_workbench.h"
#include "output.h"
#include "progress.h"
#include "real_time.h"
#include "values.h"

namespace merker::app {
namespace {

using compilation::NetworkBuild;
using compilation::NetworkOperands;

struct NetworkWishes {
  std::vector<simulator::Assignment> set;
  std::vector<StationWatched> print, watch;
};

int told(const std::string& text, int code) {
  std::cerr << "merker run: " << text << '\n';
  return code;
}

// The options that are of one station.
std::string_view ofOneStation(const RunOptions& options) {
  if (!options.project.cpu.empty()) return "--cpu";
  if (!options.card.empty()) return "--card";
  if (options.hasCycles) return "--cycles";
  if (!options.serial.connection.empty() || !options.serial.record.empty()) return "--serial";
  return {};
}

int readWishes(const RunOptions& options, const NetworkBuild& build,
               const NetworkOperands& operands, NetworkWishes& wishes) {
  return std::max(
      {readAssignments("--set", options.set, operands.resolver(std::nullopt), wishes.set),
       readWatched("--print", options.print, build, operands, wishes.print),
       readWatched("--watch", options.watch, build, operands, wishes.watch)});
}

// All at the same instant. The exit code.
int startAll(network::Network& network) {
  for (std::size_t i = 0; i < network.size(); ++i) {
    controller::Controller& plc = network.itself(i);
    plc.memoryReset();
    plc.start();
    if (plc.mode() == controller::Mode::Stop)
      return told(
          fmt::format("the CPU of {} does not start: {}", network.name(i), plc.stopReason()),
          kFault);
  }
  return kGood;
}

int setAll(const std::vector<simulator::Assignment>& assignments, network::Network& network) {
  for (const simulator::Assignment& one : assignments) {
    const std::string reason = simulator::apply(one, false, network.station(0));
    if (!reason.empty()) return told("--set: " + reason, kUsage);
  }
  return kGood;
}

// Virtual time for about a tenth of a second of real time: long portions are faster, because a
// station that moves stays in the cache, short ones show progress.
class Portion {
 public:
  Duration length() const { return length_; }
  void took(std::chrono::steady_clock::duration real) {
    using std::chrono::milliseconds;
    if (real < milliseconds(50))
      length_ = std::min(length_ + length_, kLongest);
    else if (real > milliseconds(200))
      length_ = std::max(Duration{length_.ns / 2}, kShortest);
  }

 private:
  static constexpr Duration kShortest = Duration::milliseconds(100);
  static constexpr Duration kLongest = Duration::seconds(3600);
  Duration length_ = kShortest;
};

void runNetworkFor(network::Network& network, Duration time, NetworkTrace* trace) {
  Portion portion;
  Progress progress("running");
  const Instant start = network.now(), end = start + time;
  while (network.now() < end) {
    const auto before = std::chrono::steady_clock::now();
    network.advanceTo(std::min(end, network.now() + portion.length()));
    portion.took(std::chrono::steady_clock::now() - before);
    if (trace != nullptr) trace->write(network.now());
    progress.show(static_cast<double>((network.now() - start).ns) / static_cast<double>(time.ns));
  }
}

// Until Ctrl-C.
void runNetworkInRealTime(network::Network& network, std::ofstream& file, NetworkTrace* trace,
                          NetworkS7& s7, Bell& bell) {
  const auto slice = [&] {
    s7.look();
    if (trace == nullptr) return;
    trace->write(network.now());
    file.flush();
  };
  runRealTime(network.station(0), nullptr,
              {.slice = slice, .waiting = [&] { return s7.waits(); }, .bell = &bell});
}

void printAll(const NetworkWishes& wishes, network::Network& network) {
  for (const StationWatched& one : wishes.print) printValues(one.what, network.itself(one.station));
}

void printAllAsJson(const NetworkWishes& wishes, network::Network& network) {
  nlohmann::ordered_json document = {{"seconds", static_cast<double>(network.now().ns) / 1e9},
                                     {"stations", nlohmann::ordered_json::object()}};
  for (std::size_t i = 0; i < network.size(); ++i)
    addState(network.itself(i), document["stations"][network.name(i)]);
  for (const StationWatched& one : wishes.print)
    addValues(one.what, network.itself(one.station), document);
  std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

int concludeAll(const RunOptions& options, const NetworkWishes& wishes, network::Network& network) {
  options.json ? printAllAsJson(wishes, network) : printAll(wishes, network);
  int code = kGood;
  for (const StationWatched& one : wishes.print)
    if (!allExist(one.what.operands, network.itself(one.station))) code = kProblems;
  for (std::size_t i = 0; i < network.size(); ++i)
    if (network.itself(i).stoppedByFault())
      code = told(fmt::format("the CPU of {} went to STOP: {}", network.name(i),
                              network.itself(i).stopReason()),
                  kFault);
  return code;
}

int useEngines(const RunOptions& options, bool realTime, network::Network& network) {
  for (std::size_t i = 0; i < network.size(); ++i)
    if (const auto problem = useEngine(options.engine, network.itself(i), realTime))
      return told(network.name(i) + ": " + *problem, kUsage);
  return kGood;
}

int runBuilt(const RunOptions& options, const NetworkBuild& build, std::optional<Duration> time) {
  const NetworkOperands operands(build);
  NetworkWishes wishes;
  if (const int bad = readWishes(options, build, operands, wishes)) return bad;
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  const auto network = build.network(options.threads.value_or(processors));
  for (std::size_t i = 0; i < network->size(); ++i) useSkipping(options.noSkip, network->itself(i));
  if (const int bad = useEngines(options, !time, *network)) return bad;
  if (const int bad = startAll(*network)) return bad;
  if (const int bad = setAll(wishes.set, *network)) return bad;
  std::ofstream file;
  std::optional<NetworkTrace> trace;
  const auto cannotWrite = [&] {
    return told(fmt::format("cannot write {}: {}", options.trace, std::strerror(errno)),
                kUnreadable);
  };
  if (!options.trace.empty()) {
    file.open(options.trace, std::ios::binary);
    if (!file) return cannotWrite();
    trace.emplace(file, *network, wishes.watch);
  }
  NetworkTrace* const seen = trace ? &*trace : nullptr;
  if (time) {
    runNetworkFor(*network, *time, seen);
  } else {
    Bell bell;  // outlives the servers
    NetworkS7 s7;
    const auto wake = [&bell] { bell.ring(); };
    if (const int bad = s7.open("merker run", options.serve.s7, build, *network, wake)) return bad;
    runNetworkInRealTime(*network, file, seen, s7, bell);
  }
  network->settle(time ? controller::Controller::kLongestCycle : Duration::seconds(1));
  if (trace) trace->write(Instant::never());
  file.close();
  const int code = concludeAll(options, wishes, *network);
  return options.trace.empty() || file ? code : cannotWrite();
}

}  // namespace

// What only a run without the page can do: it starts the stations itself.
bool showsNothing(const RunOptions& options) {
  return options.set.empty() && options.print.empty() && options.trace.empty() &&
         options.serve.s7.place.empty();
}

int runNetwork(const RunOptions& options, project::Project project, std::optional<Duration> time) {
  if (const auto option = ofOneStation(options); !option.empty())
    return told(fmt::format("{} is for one station: name it with --station", option), kUsage);
  // A station has one observer of its cycles.
  if (!options.serve.s7.place.empty() && !options.trace.empty())
    return told("--s7 and --trace exclude each other with several stations", kUsage);
  if (!time && !options.noWorkbench && showsNothing(options)) {
    ServeOptions serving = options.serve;
    serving.project = options.path;
    return runNetworkWorkbench("merker run", serving, std::move(project));
  }
  const NetworkBuild build = compilation::buildNetwork(std::move(project), true);
  printProblems(build.problems, build.files());
  if (!build.ok()) {
    if (options.json) print({{"problems", toJson(build.problems)}});
    return build.unreadable ? kUnreadable : kProblems;
  }
  if (!time) holdSignals();  // before threads of the network begin: a signal ends none of them
  if (!time && !options.noWorkbench)
    std::cerr
        << "merker run: with --set, --print, --trace or --s7 several stations run without the "
           "workbench, until Ctrl-C; "
           "--station NAME shows one of them in it\n";
  return runBuilt(options, build, time);
}

}  // namespace merker::app
