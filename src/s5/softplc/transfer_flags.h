// Transfer flags MB 0 to MB 24: what the operating system tells the program (S5-FLAG, 7.1).
#pragma once

#include <cstdint>

#include "softplc/alarm_input.h"
#include "softplc/machine.h"
#include "softplc/surroundings.h"

namespace merker::sinumerik {

class TransferFlags {
 public:
  explicit TransferFlags(Machine& machine) : m_(machine) {}

  // At start-up. M 3.0 tells OB 20 which kind it is; the bits of MB 2 and MB 3 say that a level has
  // not yet run completely since the cold start.
  void start(bool cold);
  void enterLevel(std::uint8_t ob, const Surroundings& around);
  void resumeLevel(std::uint8_t ob);    // an interrupted one goes on
  void levelComplete(std::uint8_t ob);  // its first pass is over
  void ipoClock(bool idle);             // the blink clock; shown at once if no level runs
  void startUpOver();                   // the blink clock begins
  void showEdges(Edges edges);
  void delayed();  // M 6.2
  void fault();    // M 8.0

  // The state of the blink clock, and how many IPO clocks until it turns.
  bool blink() const { return blink_; }
  int clocksUntilBlink() const;
  std::uint8_t level() const { return level_; }
  void pass(std::uint64_t ipoClocks) { ipoClocks_ += static_cast<int>(ipoClocks); }

 private:
  void setBit(unsigned byte, unsigned bit, bool on);
  void showBlink() { setBit(0, 7, blink_); }

  Machine& m_;
  bool blink_ = false;
  int ipoClocks_ = 0;  // that have passed since the last change
  // MB 1 is written when another level begins: the manual's binary divider (9.3.2) has an edge flag
  // in it.
  std::uint8_t level_ = 0;
};

}  // namespace merker::sinumerik
