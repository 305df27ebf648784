// memory reset, copy RAM to ROM, remove card.
#pragma once

#include <string>

#include "cpu/cpu.h"
#include "scenario/steps/bare.h"
#include "station/station.h"

namespace merker::simulator::steps {

struct MemoryReset : Bare {
  bool perform(StepRun& run) const {
    if (!run.powered()) return false;
    if (run.plc().mode() != controller::Mode::Stop) run.plc().stop();
    run.plc().memoryReset();
    return true;
  }
};

struct CopyRamToRom : Bare {
  bool perform(StepRun& run, station::Station& station) const {
    if (!run.powered()) return false;
    const std::string reason = station.copyRamToRom();
    return reason.empty() || run.fail(reason);
  }
};

// Pulled out and plugged in again: no start before a memory reset (S7-CPU-03).
struct RemoveCard : Bare {
  bool perform(StepRun& run, station::Station& station) const {
    if (!run.powered()) return false;
    station.cpu().requestMemoryReset();
    return true;
  }
};

}  // namespace merker::simulator::steps
