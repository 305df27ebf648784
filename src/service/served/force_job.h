// What is forced, as a job of a programming device.
#pragma once

#include "monitor/monitor.h"
#include "s7comm/test_job.h"

namespace merker::served {

// Whoever has forced it.
s7comm::TestJob forceJobOf(const monitor::Monitor& monitor, std::uint8_t number);
// All of it or nothing.
s7comm::Error forceAll(monitor::Monitor& monitor, const std::vector<s7comm::TestItem>& items);
// In the place of what is forced now.
s7comm::Error forceInstead(monitor::Monitor& monitor, const std::vector<s7comm::TestItem>& items);

}  // namespace merker::served
