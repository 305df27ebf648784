// A request of test and installation that is carried out, and what it begins.
#pragma once

#include "served/bench.h"

namespace merker::served {

struct TestCall {
  Bench& bench;
  monitor::Monitor& monitor;
  const s7comm::TestRequest& request;
  const Bench::Client& client;
  std::uint8_t number = 0;

  Tasks& tasks() const { return bench.tasks_; }
  s7comm::TestJob numbered() const {
    s7comm::TestJob job = request.job;
    job.name.number = number;
    return job;
  }
  std::uint8_t forceNumber() const { return bench.forceNumber(monitor); }
  void forced() const { bench.force_ = number; }
};

// Whether a job for these variables can be.
s7comm::Error checkVariables(const TestCall& call);
s7comm::TestAnswer beginVariables(const TestCall& call);
s7comm::TestAnswer beginForce(const TestCall& call);
s7comm::TestAnswer beginBlock(const TestCall& call);
s7comm::TestAnswer beginBreakpoint(const TestCall& call);
// Out of HALT, up to the next breakpoint or statement.
s7comm::TestAnswer exitHold(const TestCall& call);
s7comm::TestAnswer beginFlash(const TestCall& call);
s7comm::TestAnswer interruptStack(const TestCall& call);
s7comm::TestAnswer blockStack(const TestCall& call);
s7comm::TestAnswer localStack(const TestCall& call);

}  // namespace merker::served
