// HALT: the program stands still in front of an instruction, and with it its timers, its raster,
// the monitoring of times and the jobs of function macros. The clock goes on.
#include "softplc/operating_system.h"

namespace merker::sinumerik {

bool OperatingSystem::hold() {
  if (!executes(mode_)) return false;
  held_ = {mode_, machine_.clock};
  mode_ = Mode::Halt;
  return true;
}

bool OperatingSystem::resume() {
  if (mode_ != Mode::Halt) return false;
  delayProgram(machine_.clock - held_.since);
  mode_ = held_.mode;
  return true;
}

// What has come to the alarm byte meanwhile is found by the next sampling: its module did not wait.
void OperatingSystem::delayProgram(Duration by) {
  schedule_.delay(by);
  cycleStart_ = cycleStart_ + by;
  if (watchdog_ != Instant::never()) watchdog_ = watchdog_ + by;
  for (Timer& timer : machine_.timers) timer.delay(by);
  if (options_.macros != nullptr) options_.macros->delay(by);
}

bool OperatingSystem::probe(mc5::BlockId block, Probe* probe) {
  if (block.type == mc5::BlockType::Db) return false;
  probes_.place(block, probe);
  compiledVersion_ = ~std::uint64_t{0};
  return machine_.blocks.find(block).present;
}

}  // namespace merker::sinumerik
