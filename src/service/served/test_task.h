// Jobs of test and installation in the PLC's thread: what one says, and when.
#pragma once

#include "s7comm/test_job.h"
#include "served/tasks.h"

namespace merker::served {

class TestTask : public Task {
 public:
  TestTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job)
      : Task(std::move(client)), job_(std::move(job)) {}

  const s7comm::TestJob& job() const { return job_; }
  bool enabled() const { return enabled_; }
  virtual void enable(bool on) { enabled_ = on; }
  virtual bool isReplaceable() const { return false; }
  virtual void replace(s7comm::TestJob job) {
    job.name = job_.name;
    job_ = std::move(job);
  }

 protected:
  void tell(s7comm::View data) const {
    client().send({.group = 1,
                   .subfunction = job_.name.function,
                   .sequence = job_.name.number,
                   .octets = s7comm::testOctets(data)});
  }

 private:
  s7comm::TestJob job_;
  bool enabled_ = false;
};

// Status of variables, and their modification (S7-SIM-12). A status is told once each time that the
// job is enabled: that is how a client says that it has read the last one.
class VariableTask final : public TestTask, public monitor::PointWatcher {
 public:
  VariableTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job,
               monitor::Monitor& monitor);

  bool run(monitor::Monitor& monitor) override;
  void reached(monitor::CyclePoint point) override;
  bool isReplaceable() const override { return true; }
  void replace(s7comm::TestJob job) override;

 private:
  void begin();
  void act(bool inCycle);
  void look();
  void modify(bool inCycle);

  monitor::Monitor& monitor_;
  bool told_ = false, over_ = false;
};

}  // namespace merker::served
