// The LEDs on the front of a PLC.
#pragma once

#include "cpu/leds.h"
#include "plc/capability.h"

namespace merker::cpu {

class LedPanel : public controller::Capability {
 public:
  static constexpr std::string_view kName = "LEDs";

  virtual Leds leds() const = 0;
};

}  // namespace merker::cpu
