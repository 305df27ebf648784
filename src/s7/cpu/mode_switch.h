// The mode switch on the front (S7-CPU-31, S7-SIM-11): RUN-P, RUN, STOP and, with a spring, MRES.
// Memory reset by hand: hold MRES for three seconds, let go, and back to MRES within three seconds
// (manual "CPU 31xC and CPU 31x: Installation", memory reset with the mode selector switch).
#pragma once

#include <cstdint>

#include "clock/instant.h"

namespace merker::cpu {

enum class SwitchPosition : std::uint8_t { RunP, Run, Stop, Mres };

class ModeSwitch {
 public:
  SwitchPosition position() const { return position_; }
  bool allowsRun() const {
    return position_ == SwitchPosition::RunP || position_ == SwitchPosition::Run;
  }
  // True: the switch has now asked for memory reset.
  bool turn(SwitchPosition to, Instant now);

  enum class Sequence : std::uint8_t { None, Pressed, Armed, Reset };
  // How far memory reset by hand has come, for the STOP LED.
  Sequence sequence(Instant now) const;

 private:
  SwitchPosition position_ = SwitchPosition::RunP;
  Instant pressed_ = Instant::never();  // MRES for the first time
  Instant armed_ = Instant::never();    // let go in time
  Instant reset_ = Instant::never();    // MRES for the second time
};

}  // namespace merker::cpu
