// Test and installation of a PLC, in its thread: the jobs of all programming devices. They are
// tasks of their connections; what is forced stays without one, and is a job of everybody's.
#pragma once

#include "s7comm/test_job.h"
#include "served/tasks.h"

namespace merker::served {

class Bench {
 public:
  using Client = std::shared_ptr<s7comm::Outlet>;

  explicit Bench(Tasks& tasks) : tasks_(tasks) {}
  s7comm::TestAnswer carryOut(monitor::Monitor& monitor, const s7comm::TestRequest& request,
                              const Client& client);
  // Of everybody.
  std::size_t jobs(const monitor::Monitor& monitor) const;

 private:
  friend struct TestCall;
  std::uint8_t freshNumber(const monitor::Monitor& monitor);
  std::uint8_t forceNumber(const monitor::Monitor& monitor);

  Tasks& tasks_;
  std::uint8_t last_ = 0;   // number of a request
  std::uint8_t force_ = 0;  // number of the job that forces; 0: none has one
};

}  // namespace merker::served
