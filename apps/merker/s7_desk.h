// The S7 server and the PLC that it serves: the one that the workbench shows, or the one of a run
// without it.
#pragma once

#include "s7_server.h"
#include "workbench/workbench.h"

namespace merker::app {

class S7Desk {
 public:
  // Nothing without the option. `station`: its name, if it is one of several. The exit code; what
  // is wrong is told.
  int open(const std::string& command, const S7Option& option,
           const CommunicationParameters& parameters, std::function<void()> wake,
           std::string station = {});
  // Without a place if it is not open.
  workbench::S7Outside outside() const;
  bool isOpen() const { return server_ != nullptr; }
  S7Server& server() { return *server_; }  // it is open
  S7Desk() = default;
  ~S7Desk();
  S7Desk(const S7Desk&) = delete;
  S7Desk& operator=(const S7Desk&) = delete;

  // In front of each slice of time. `fresh`: it is another PLC, or none, from now on.
  void exchange(workbench::Plc* plc, bool fresh);
  void exchange(monitor::Monitor& monitor);
  // Somebody waits for the end of a cycle.
  bool waits() const;
  // For each end of a cycle of this PLC; it may be called when the server has gone.
  std::function<void(controller::Controller&)> cycleObserver(monitor::Monitor& monitor) const;

 private:
  void follow(workbench::Plc* plc);

  std::shared_ptr<S7Server> server_;
  std::string title_ = "S7 communication";
};

}  // namespace merker::app
