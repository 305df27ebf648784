// memory reset, copy RAM to ROM, remove card.
#pragma once

#include <string>

#include "cpu/ram_to_rom.h"
#include "plc/card_slot.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct MemoryReset : Bare {
  static constexpr std::string_view kWords = "memory reset";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const {
    if (!run.powered()) return false;
    if (run.plc().mode() != controller::Mode::Stop) run.plc().stop();
    run.plc().memoryReset();
    run.clearForces();
    return true;
  }
};

struct CopyRamToRom : Bare {
  static constexpr std::string_view kWords = "copy RAM to ROM";

  bool perform(StepRun& run) const {
    auto* const memory = run.need<cpu::RamToRom>();
    if (memory == nullptr || !run.powered()) return false;
    const std::string reason = memory->copyRamToRom({});
    return reason.empty() || run.fail(reason);
  }
};

// Pulled out and plugged in again: no start before a memory reset (S7-CPU-03).
struct RemoveCard : Bare {
  static constexpr std::string_view kWords = "remove card";

  bool perform(StepRun& run) const {
    auto* const slot = run.need<controller::CardSlot>();
    if (slot == nullptr || !run.powered()) return false;
    slot->removeCard();
    return true;
  }
};

}  // namespace merker::simulator::steps
