// What a reference-point run looks for: the switch, its end in the direction in which the reference
// point lies, the next zero mark (technology manual 3.4.4; POS-REF). Edges come as the hardware
// sees them, between two cycles.
#pragma once

#include <cstdint>

namespace merker::positioning {

class ReferenceSearch {
 public:
  // `location`: the direction from the switch to the reference point.
  ReferenceSearch(int location, bool onSwitch)
      : location_(location), phase_(onSwitch ? Phase::OnSwitch : Phase::Away) {}

  int location() const { return location_; }
  bool onSwitch() const { return phase_ != Phase::Away; }
  bool found() const { return phase_ == Phase::Found; }

  // Only an end that is passed in the direction of the location counts (POS-REF-09).
  void switchEdge(bool rising, int movement) {
    if (phase_ == Phase::Away && rising) phase_ = Phase::OnSwitch;
    if (phase_ == Phase::OnSwitch && !rising && movement == location_) phase_ = Phase::Armed;
  }
  // True: this is the reference point.
  bool zeroMark() {
    if (phase_ != Phase::Armed) return false;
    phase_ = Phase::Found;
    return true;
  }

 private:
  enum class Phase : std::uint8_t { Away, OnSwitch, Armed, Found };
  int location_;
  Phase phase_;
};

}  // namespace merker::positioning
