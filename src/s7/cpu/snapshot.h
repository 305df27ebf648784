// Everything that a CPU holds between two cycles, as plain values: what a simulator saves and loads
// (S7-SIM-13). Instants are those of a clock that showed `memory.now`.
#pragma once

#include <cstdint>
#include <vector>

#include "cpu/cycle_times.h"
#include "cpu/interrupts.h"
#include "cpu/mode_switch.h"
#include "plc/retentive.h"

namespace merker::cpu {

struct Snapshot {
  // All flags, timers, counters and data blocks, not only the retentive ones.
  block::RetentiveData memory;
  std::vector<std::uint8_t> images;           // E, then A
  std::vector<std::uint8_t> inputs, outputs;  // periphery
  bool run = false;                           // else STOP
  SwitchPosition position = SwitchPosition::RunP;
  bool stoppedByFault = false, timersHeld = false;
  std::vector<block::RetentiveEvent> stopEvent;  // one, or none
  Interrupts interrupts;                         // none waits between two cycles
  std::int64_t systemTime = 0;                   // ns, SFC 64
  // OB 1
  std::uint8_t scan = 1;
  CycleTimes cycleTimes;
  std::int64_t cycleBegan = 0, nextCycle = 0;
};

}  // namespace merker::cpu
