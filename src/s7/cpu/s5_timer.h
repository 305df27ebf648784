// One S5 timer (S7-TMR). It is computed from the virtual clock when somebody looks: nothing ticks,
// so it expires exactly at start + preset.
#pragma once

#include <cstdint>

#include "clock/instant.h"

namespace merker::cpu {

struct S5Timer {
  enum class Kind : std::uint8_t { Pulse, ExtendedPulse, OnDelay, StoredOnDelay, OffDelay };

  Kind kind = Kind::Pulse;
  bool startEdge = false;    // RLO at the last start instruction
  bool enableEdge = false;   // RLO at the last FR
  bool started = false;      // runs or has run out; false after R or a stop
  bool held = false;         // status 1 whatever the time: SA whose start is 1, SS started anew
  std::uint8_t base = 0;     // 0 = 10 ms, 1 = 100 ms, 2 = 1 s, 3 = 10 s
  std::uint16_t frozen = 0;  // units left when a stop ended the run early
  Instant end;
  bool operator==(const S5Timer&) const = default;

  // SI, SV, SE, SS, SA with the S5TIME in accumulator 1. False: the value is needed and is no BCD
  // number (S7-TMR-04); the timer then stays as it is.
  bool start(Kind how, bool rlo, std::uint16_t s5time, Instant now);
  void enable(bool rlo);  // FR
  void reset(bool rlo);   // R

  // As a programming device modifies it: the rest of its time from now on; 0 resets it. False: no
  // BCD number.
  bool modify(std::uint16_t s5time, Instant now);

  // A time that runs begins anew with the units that are left of it.
  void hold(Instant now);

  bool status(Instant now) const;          // U T
  std::uint16_t units(Instant now) const;  // L T: 0 … 999, no base
  // The first instant after `from` at which units() is another number; the end if it is over.
  Instant nextUnit(Instant from) const;
  std::uint16_t s5time(Instant now) const;  // LC T: BCD with the base in bits 13..12

 private:
  bool run(std::uint16_t s5time, Instant now);
  void stop(Instant now);
  bool expired(Instant now) const { return now >= end; }
};

}  // namespace merker::cpu
