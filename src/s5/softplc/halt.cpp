// HALT: the program stands still in front of an instruction, and with it its timers, its raster,
// the monitoring of times and the jobs of function macros. The clock goes on.
#include "softplc/operating_system.h"

namespace merker::sinumerik {

// What has come to the alarm byte meanwhile is found by the next sampling: its module did not wait.
bool OperatingSystem::resume() {
  const auto held = state_.resume(machine_.clock);
  if (!held) return false;
  schedule_.delay(*held);
  watch_.delay(*held);
  for (Timer& timer : machine_.timers) timer.delay(*held);
  if (options_.macros != nullptr) options_.macros->delay(*held);
  return true;
}

bool OperatingSystem::probe(mc5::BlockId block, Probe* probe) {
  if (block.type == mc5::BlockType::Db) return false;
  probes_.place(block, probe);
  compiled_.forget();
  return machine_.blocks.find(block).present;
}

}  // namespace merker::sinumerik
