// The mode switch on the front of a PLC.
#pragma once

#include "cpu/mode_switch.h"
#include "plc/capability.h"

namespace merker::cpu {

class SwitchPanel : public controller::Capability {
 public:
  static constexpr std::string_view kName = "mode switch";

  // From STOP to RUN or RUN-P it starts the CPU.
  virtual void setSwitch(SwitchPosition position) = 0;
  virtual SwitchPosition switchPosition() const = 0;
};

}  // namespace merker::cpu
