// S7 servers of several stations: each station has its own, at ports one behind the other in the
// order of the stations, as programming devices reach each CPU of a subnet (S7-NET-01). The first
// one leads to the others, too (S7-NET-15).
#pragma once

#include <deque>

#include "compilation/network.h"
#include "s7_desk.h"
#include "s7_ways.h"

namespace merker::app {

class NetworkS7 {
 public:
  // `network` outlives it. Nothing without the option. The exit code; what is wrong is told.
  // `wake`: somebody waits for the thread of the stations; from any thread.
  int open(const std::string& command, const S7Option& option,
           const compilation::NetworkBuild& build, network::Network& network,
           const std::function<void()>& wake);
  NetworkS7() = default;
  ~NetworkS7();  // nobody looks at the stations any more
  NetworkS7(const NetworkS7&) = delete;
  NetworkS7& operator=(const NetworkS7&) = delete;

  // In front of each slice of time.
  void look();
  // Somebody waits for the end of a cycle.
  bool waits() const;

 private:
  struct Served {
    Served(controller::Controller& of, std::unique_ptr<monitor::Monitor> by)
        : plc(of), monitor(std::move(by)) {}
    controller::Controller& plc;
    std::unique_ptr<monitor::Monitor> monitor;
    S7Desk desk;
  };
  int serve(const std::string& command, const S7Option& option, const compilation::NamedBuild& one,
            controller::Controller& plc, const std::function<void()>& wake);
  void route(const compilation::NetworkBuild& build);
  std::deque<Served> served_;  // the first one goes first: it passes clients on
  S7Ways ways_;
  network::Network* network_ = nullptr;
};

}  // namespace merker::app
