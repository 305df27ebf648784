// The LED test of a programming device: FRCE flashes, so that one finds this PLC among others.
#pragma once

#include "served/test_task.h"

namespace merker::served {

class FlashTask final : public TestTask {
 public:
  // Of virtual time; or until it is deleted.
  static constexpr Duration kLength = Duration::seconds(10);

  FlashTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job,
            const monitor::Monitor& monitor);

  bool run(monitor::Monitor& monitor) override;
  void end(monitor::Monitor& monitor) override;

 private:
  Instant until_;
};

}  // namespace merker::served
