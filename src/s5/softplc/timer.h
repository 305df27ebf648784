// A timer cell (S5-TIMER, 9.3.4). The program sees it as a word (OP-33): bit 15 ZWG running,
// 14 ZKS output, 13..12 base, 11 FMS edge of the start, 10 edge of FR, 9..0 value, binary.
#pragma once

#include <array>
#include <cstdint>

#include "clock/instant.h"

namespace merker::sinumerik {

enum class TimerKind : std::uint8_t { SI, SV, SE, SS, SA };

// Real length of one unit of the bases 0.01, 0.1, 1 and 10 s (S5-SCHED-T2).
using TimeBases = std::array<Duration, 4>;

class Timer {
 public:
  static constexpr std::uint16_t kRunning = 0x8000, kOutput = 0x4000, kStartEdge = 0x0800,
                                 kEnableEdge = 0x0400, kValue = 0x03FF;

  std::uint16_t word() const { return word_; }
  void setWord(std::uint16_t word) { word_ = word; }  // SU T, RU T: bits as they are
  bool output() const { return (word_ & kOutput) != 0; }
  std::uint16_t value() const { return word_ & kValue; }  // L T
  std::uint16_t coded() const;                            // LC T: base and three digits

  // SI SV SE SS SA with the value of AKKU 1 (base and BCD digits). True if it did anything.
  bool start(TimerKind kind, bool vke, std::uint16_t akku, Instant now, const TimeBases& bases);
  bool reset(bool vke);   // R T
  bool enable(bool vke);  // FR T
  void clearControlBits() {
    word_ &= static_cast<std::uint16_t>(~(kRunning | kOutput | kStartEdge));
  }
  // The operating system counts the units that have passed; at instants of the sampling raster.
  void count(Instant now, const TimeBases& bases);
  // When its value falls by one; never if it does not run.
  Instant next() const { return (word_ & kRunning) != 0 ? next_ : Instant::never(); }
  // It stood still for so long.
  void delay(Duration by) {
    if (next_ != Instant::never()) next_ = next_ + by;
  }

 private:
  // `kept`: bits that stay beside the edge memories.
  void begin(std::uint16_t akku, Instant now, const TimeBases& bases, std::uint16_t kept = 0);
  void set(std::uint16_t bit, bool on) {
    word_ = static_cast<std::uint16_t>(on ? word_ | bit : word_ & ~bit);
  }
  void expire();
  void clear();
  unsigned base() const { return word_ >> 12 & 3; }

  std::uint16_t word_ = 0;
  TimerKind kind_ = TimerKind::SI;
  Instant next_ = Instant::never();  // when the value falls by one
};

}  // namespace merker::sinumerik
