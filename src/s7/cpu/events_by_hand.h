// A PLC that takes events made by hand (S7-SIM-13).
#pragma once

#include "cpu/trigger.h"
#include "plc/capability.h"

namespace merker::cpu {

class EventsByHand : public controller::Capability {
 public:
  static constexpr std::string_view kName = "events that can be triggered";

  // As if it had happened: entry, OB or STOP.
  virtual void trigger(const Trigger& event) = 0;
};

}  // namespace merker::cpu
