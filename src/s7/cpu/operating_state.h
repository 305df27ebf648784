// Operating states and the ways between them (S7-STATE-01 … -08).
#pragma once

#include <cstdint>

namespace merker::cpu {

enum class Mode : std::uint8_t { Stop, Startup, Run, Halt };
enum class Restart : std::uint8_t {
  ManualWarm,
  AutomaticWarm,
  ManualHot,
  AutomaticHot,
  ManualCold,
  AutomaticCold
};

constexpr bool isHot(Restart how) {
  return how == Restart::ManualHot || how == Restart::AutomaticHot;
}
constexpr bool isCold(Restart how) {
  return how == Restart::ManualCold || how == Restart::AutomaticCold;
}

// Whether instructions are executed.
constexpr bool executes(Mode mode) { return mode == Mode::Startup || mode == Mode::Run; }

// S7-STATE-08: from row to column; there are no other changes.
constexpr bool isTransition(Mode from, Mode to) {
  constexpr bool kAllowed[4][4] = {// STOP   STARTUP RUN   HALT
                                   {false, true, false, false},
                                   {true, false, true, true},
                                   {true, false, false, true},
                                   {true, true, true, false}};
  return kAllowed[static_cast<unsigned>(from)][static_cast<unsigned>(to)];
}

}  // namespace merker::cpu
