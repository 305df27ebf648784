// trigger OB 82 coming address 256 data DW#16#05000000: an event made by hand.
#pragma once

#include "cpu/events_by_hand.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct Trigger {
  static constexpr std::string_view kWords = "trigger";

  cpu::Trigger event{};

  bool parse(const StepLine& line);
  void resolve(const StepBinding&) {}
  bool perform(StepRun& run) const;
};

}  // namespace merker::simulator::steps
