// Cyclic, time-delay and time-of-day interrupts with their next instants, and which OBs are locked
// (S7-BLK-08 … -10).
#pragma once

#include <cstdint>
#include <vector>

#include "clock/instant.h"
#include "cpu/start_information.h"

namespace merker::cpu {

struct CyclicInterrupt {
  std::uint8_t ob = 35;
  std::int32_t milliseconds = 100;
  Instant next{};
  std::int32_t phase = 0;  // ms behind the common beginning
  void begin(Instant now) { next = now + Duration::milliseconds(milliseconds + phase); }
};

struct DelayInterrupt {
  std::uint8_t ob = 20;
  bool active = false;
  bool finished = false;  // has been called, SFC 34
  std::uint16_t sign = 0;
  std::uint32_t milliseconds = 0;
  Instant due{};
};

// PERIOD of SFC 28.
enum class Period : std::uint16_t {
  Once = 0x0000,
  Minute = 0x0201,
  Hour = 0x0401,
  Day = 0x1001,
  Week = 0x1201,
  Month = 0x1401,
  Year = 0x1801,
  EndOfMonth = 0x2001
};

struct TimeOfDayInterrupt {
  std::uint8_t ob = 10;
  bool set = false, active = false, expired = false;
  Period period = Period::Once;
  std::int64_t start = 0;  // ms since 1990-01-01
  std::int64_t due = 0;
  // To the next time after now; expired if there is none.
  void moveOn(std::int64_t now);
};

struct Interrupts {
  std::vector<CyclicInterrupt> cyclic;
  std::vector<DelayInterrupt> delay;
  std::vector<TimeOfDayInterrupt> timeOfDay;
  std::vector<std::uint8_t> locked;  // OB numbers that SFC 39 has locked

  DelayInterrupt* findDelay(std::uint32_t ob);
  TimeOfDayInterrupt* findTimeOfDay(std::uint32_t ob);
  bool isLocked(std::uint8_t ob) const;
};

// The first time after `now` at which a periodic interrupt that began at `start` is due; -1 = never
// again.
std::int64_t nextTimeOfDay(std::int64_t start, Period period, std::int64_t now);
bool isPeriod(std::uint32_t word);

// Default intervals of OB 30..38 in ms (S7-BLK-10).
std::int32_t defaultInterval(std::uint8_t ob);

}  // namespace merker::cpu
