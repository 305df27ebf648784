// A breakpoint of a programming device (S7-STATE-07): in HALT there, its job tells the registers.
#pragma once

#include "served/test_task.h"

namespace merker::served {

class BreakpointTask final : public TestTask {
 public:
  BreakpointTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job,
                 monitor::Monitor& monitor);

  bool run(monitor::Monitor& monitor) override;
  void end(monitor::Monitor& monitor) override;
  void enable(bool on) override;
  // Out of HALT: the next one is told again.
  void goOn() { told_ = false; }

 private:
  bool standsHere(const monitor::Monitor& monitor) const;
  s7comm::Bytes data(const monitor::Monitor& monitor) const;

  monitor::Monitor& monitor_;
  monitor::SourcePlace place_;
  unsigned number_ = 0;  // of the debugger
  bool told_ = false;
};

}  // namespace merker::served
