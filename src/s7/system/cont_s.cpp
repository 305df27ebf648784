// SFB 42 CONT_S: PI step controller for motor actuators without position feedback (technology
// manual 7.5.2). The manual names the adaption of the response threshold without its rule; the one
// here is decided in docs/compatibility.md, "Closed-loop control".
#include <algorithm>
#include <cmath>

#include "system/closed_loop.h"

namespace merker::system {
namespace {

// Constants of the adaption (PID-CONS-13): the motor counts as 10 % faster, half a call decides;
// no threshold is higher than 10 %.
constexpr float kMotorPercent = 110.0F, kHalf = 0.5F, kHighestThreshold = 10.0F;

void restart(Sfb<42>& a) { a.clear("QLMNUP", "BREAK_LEFT"); }

float cycle(Sfb<42>& a) { return seconds(a, "CYCLE"); }

// A travel time that is none counts as one call (PID-OP-08).
float travelTime(Sfb<42>& a) {
  return seconds(a.longInteger("MTR_TM") > 0 ? a.longInteger("MTR_TM") : a.longInteger("CYCLE"));
}

// The assumed way of the actuator less the integrated error, in one integrator (PID-CONS-11).
float integrated(Sfb<42>& a, float e) {
  if (a.flag("LMNS_ON")) return 0;  // PID-CONS-16
  const bool positions = a.longInteger("TI") == 0;
  float step = 100.0F * static_cast<float>(a.integer("DIRECTION")) * cycle(a) / travelTime(a);
  const bool held = (e > 0 && a.flag("LMNR_HS")) || (e < 0 && a.flag("LMNR_LS"));  // PID-CONS-15
  if (!positions && !held) step -= e * cycle(a) / std::max(seconds(a, "TI"), 0.5F * cycle(a));
  const float sum = a.real("INTEGRAL") + step;
  return positions ? std::clamp(sum, 0.0F, 100.0F) : sum;  // PID-CONS-17
}

// The response threshold, adapted while no pulse is out (PID-CONS-13).
float adaptedThreshold(Sfb<42>& a, float e, float integral) {
  const float least = 100.0F / travelTime(a) * std::max(seconds(a, "PULSE_TM"), cycle(a));
  if (a.flag("LMNR_HS") || a.flag("LMNR_LS")) return least;
  if (a.integer("DIRECTION") != 0) return a.real("THRESHOLD");
  const float wanted =
      a.longInteger("TI") == 0 ? kHalf * std::abs(e) : std::min(std::abs(e), std::abs(integral));
  return std::max(least, std::min(kHighestThreshold, wanted));
}

// THREE_ST: which way the motor should turn.
int wantedDirection(Sfb<42>& a, float x) {
  if (a.flag("LMNS_ON"))
    return static_cast<int>(a.flag("LMNUP")) - static_cast<int>(a.flag("LMNDN"));
  const float on = a.real("THRESHOLD");
  const float off = kHalf * kMotorPercent / travelTime(a) * cycle(a);
  const int now = a.integer("DIRECTION");
  if (x >= on || (now == 1 && x > off)) return 1;
  if (x <= -on || (now == -1 && x < -off)) return -1;
  return 0;
}

bool isStopped(Sfb<42>& a, int direction) {
  return (direction == 1 && a.flag("LMNR_HS")) || (direction == -1 && a.flag("LMNR_LS"));
}

std::uint32_t lessOneCall(Sfb<42>& a, std::int32_t left) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(
      std::max<std::int64_t>(0, std::int64_t{left} - a.longInteger("CYCLE"))));
}

// PULSEOUT (PID-CONS-14, -15): pulses last PULSE_TM at least, pauses BREAK_TM, stops act at once.
void formPulse(Sfb<42>& a, int wanted) {
  int direction = a.integer("DIRECTION");
  std::int32_t pulse = a.longInteger("PULSE_LEFT"), pause = a.longInteger("BREAK_LEFT");
  if (isStopped(a, wanted)) wanted = 0;
  const bool stopped = isStopped(a, direction);
  if (direction != 0 && (stopped || (wanted != direction && pulse <= 0))) {
    direction = 0;
    if (stopped) pulse = 0;
    pause = a.longInteger("BREAK_TM");
  }
  if (direction == 0 && wanted != 0 && pause <= 0) {
    direction = wanted;
    pulse = a.longInteger("PULSE_TM");
  }
  a.set("DIRECTION", static_cast<std::uint16_t>(direction));
  a.set("PULSE_LEFT", lessOneCall(a, pulse));
  a.set("BREAK_LEFT", lessOneCall(a, pause));
  a.set("QLMNUP", direction == 1);
  a.set("QLMNDN", direction == -1);
}

}  // namespace

void stepControl(Sfb<42>& a) {
  if (a.flag("COM_RST")) return restart(a);
  if (a.longInteger("CYCLE") <= 0) return;  // PID-OP-08
  const float e = amplifiedError(a);
  const float integral = integrated(a, e);
  a.setReal("INTEGRAL", integral);
  a.setReal("THRESHOLD", adaptedThreshold(a, e, integral));
  formPulse(a, wantedDirection(a, e - integral + a.real("DISV")));
}

}  // namespace merker::system
