// The input byte whose edges start OB 2. A change at the terminal reaches the operating system
// after the delay of the input module; then the next sampling finds it (S5-OB-07, S5-OB-15).
#pragma once

#include <cstdint>
#include <deque>

#include "clock/instant.h"

namespace merker::sinumerik {

struct Edges {
  std::uint8_t negative = 0, positive = 0;
  bool any() const { return (negative | positive) != 0; }
};

class AlarmInput {
 public:
  // The reaction time of 2 to 7.5 ms is this delay, one sampling and the start of OB 2; 3.5 to 9 ms
  // for a byte of the distributed unit.
  static constexpr Duration kCentral = Duration::microseconds(2000),
                            kDistributed = Duration::microseconds(3500);

  void begin(std::uint8_t value, Duration delay);
  void change(std::uint8_t value, Instant now);  // at the terminal
  Edges sample(Instant now);
  bool quiet() const { return coming_.empty(); }  // no change is on its way

 private:
  struct Change {
    Instant time;
    std::uint8_t value;
  };
  std::deque<Change> coming_;  // not yet through the module
  std::uint8_t last_ = 0;      // value of the last sampling
  Duration delay_ = kCentral;
};

}  // namespace merker::sinumerik
