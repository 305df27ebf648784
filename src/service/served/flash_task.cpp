#include "served/flash_task.h"

#include "station/block_cpu.h"
#include "system/communication.h"

namespace merker::served {
namespace {

void flash(monitor::Monitor& monitor, bool on) {
  controller::capability<station::BlockCpu>(monitor.plc())->communication().flashing = on;
}

}  // namespace

FlashTask::FlashTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job,
                     const monitor::Monitor& monitor)
    : TestTask(std::move(client), std::move(job)), until_(monitor.plc().now() + kLength) {
  enable(true);
}

// Another one may have ended in the meantime.
bool FlashTask::run(monitor::Monitor& monitor) {
  flash(monitor, true);
  return monitor.plc().now() < until_;
}

void FlashTask::end(monitor::Monitor& monitor) { flash(monitor, false); }

}  // namespace merker::served
