// The alarms of the PLC, described once: alarms.inc. Texts, reaction and the bits that the
// programmer shows come from there (S5-ERR-07, -08, -17).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "softplc/control_bits.h"

namespace merker::sinumerik {

enum class Alarm : std::uint16_t {
#define ALARM(number, id, text, meaning, reaction, control, cause) id = number,
#include "softplc/alarms.inc"
#undef ALARM
};

// What an alarm does; the last three as bits of MD 2003 say (S5-MD-T2).
enum class Reaction : std::uint8_t { Message, Stop, StopIfOb1, StopIfOb2, StopIfUnit };

// "Störungsursache" of the interrupt stack, in the order of the screen (S5-ERR-T2).
enum class Cause : std::uint8_t {
  NONE,
  STOPS,
  STUEB,
  NAU,
  QVZ,
  ZYK,
  BAU,
  SUF,
  STUEU,
  ADF,
  PARI,
  TRAF
};
std::string_view name(Cause cause);

class Causes {
 public:
  constexpr Causes() = default;
  explicit constexpr Causes(Cause cause) { set(cause); }
  constexpr void set(Cause cause) { bits_ = static_cast<std::uint16_t>(bits_ | mask(cause)); }
  constexpr bool test(Cause cause) const { return (bits_ & mask(cause)) != 0; }
  bool operator==(const Causes&) const = default;

 private:
  static constexpr unsigned mask(Cause cause) {
    return cause == Cause::NONE ? 0 : 1u << static_cast<unsigned>(cause);
  }
  std::uint16_t bits_ = 0;
};

struct AlarmRow {
  Alarm alarm;
  std::string_view text, meaning;
  Reaction reaction;
  ControlBit control;
  Cause cause;
};
std::span<const AlarmRow> alarmRows();
const AlarmRow& row(Alarm alarm);

constexpr unsigned number(Alarm alarm) { return static_cast<unsigned>(alarm); }
// "6105 Fehlender MC5-Baustein (MC5 block missing)"
std::string describe(Alarm alarm);

}  // namespace merker::sinumerik
