// SFB 43 PULSEGEN: pulse width modulation of an analog value in software (technology manual 7.5.3).
// A period is a number of calls; the pulse stands at its beginning.
#include <algorithm>
#include <cmath>

#include "system/closed_loop.h"

namespace merker::system {
namespace {

void put(Sfb<43>& a, bool positive, bool negative) {
  a.set("QPOS_P", positive);
  a.set("QNEG_P", negative);
}

// The next automatic call begins a period (PID-PULS-19, -24).
void beginAnew(Sfb<43>& a) {
  a.set("CALL_INDEX", 0);
  a.set("HAS_OLD", 0);
}

// PID-PULS-18
void manual(Sfb<43>& a) {
  beginAnew(a);
  const bool positive = a.flag("POS_P_ON"), negative = a.flag("NEG_P_ON");
  if (a.flag("STEP3_ON")) return put(a, positive && !negative, negative && !positive);
  put(a, positive, !positive);
}

// PID-PULS-25
std::int32_t callsOfPeriod(Sfb<43>& a) {
  const auto calls =
      std::lround(static_cast<double>(a.longInteger("PER_TM")) / a.longInteger("CYCLE"));
  return static_cast<std::int32_t>(std::clamp(calls, 1L, 32767L));
}

// Duration of the pulse in ms, and by how much its least length is shortened (PID-PULS-15 to -17).
struct Pulse {
  float duration, least;
};

Pulse pulse(Sfb<43>& a) {
  const auto period = static_cast<float>(a.longInteger("PER_TM"));
  const auto least = static_cast<float>(a.longInteger("P_B_TM"));
  const float value = a.real("INV"), ratio = a.real("RATIOFAC");
  if (a.flag("STEP3_ON")) {
    const bool positive = value >= 0;
    float factor = 1.0F;
    if (positive && ratio > 1) factor = 1.0F / ratio;
    if (!positive && ratio < 1) factor = ratio;
    return {std::abs(value) / 100.0F * period * factor, least * factor};
  }
  return {(a.flag("ST2BI_ON") ? (value + 100.0F) / 200.0F : value / 100.0F) * period, least};
}

// PID-PULS-11, -14: no pulse, no pause shorter than P_B_TM; half a call counts as a whole one.
std::int32_t callsOn(Sfb<43>& a, std::int32_t calls) {
  const auto period = static_cast<float>(a.longInteger("PER_TM"));
  auto [duration, least] = pulse(a);
  if (!(duration >= least)) return 0;  // also NaN
  if (duration > period - least) return calls;
  const float on = std::floor(duration / static_cast<float>(a.longInteger("CYCLE")) + 0.5F);
  return static_cast<std::int32_t>(std::clamp(on, 0.0F, static_cast<float>(calls)));
}

void beginPeriod(Sfb<43>& a, std::int32_t calls) {
  const bool negative = a.flag("STEP3_ON") && a.real("INV") < 0;
  a.set("SIGN", negative ? 0xFFFF : 1);
  a.set("CALLS_ON", static_cast<std::uint16_t>(callsOn(a, calls)));
}

// PID-PULS-20, -21: a new value in the middle of a period begins a new one with the next call.
bool synchronises(Sfb<43>& a, std::int32_t index, std::int32_t calls) {
  const bool changed = a.flag("HAS_OLD") && a.real("INV") != a.real("INV_OLD");
  a.set("INV_OLD", a.value("INV"));
  a.set("HAS_OLD", 1);
  return a.flag("SYN_ON") && changed && index >= 1 && index <= calls - 3;
}

}  // namespace

void pulseGenerator(Sfb<43>& a) {
  if (a.flag("COM_RST")) {
    beginAnew(a);
    return put(a, false, false);
  }
  if (a.flag("MAN_ON")) return manual(a);
  if (a.longInteger("CYCLE") <= 0) return;  // PID-OP-08
  const std::int32_t calls = callsOfPeriod(a), index = a.integer("CALL_INDEX");
  const bool synchronised = synchronises(a, index, calls);
  if (index == 0) beginPeriod(a, calls);
  const bool on = index<a.integer("CALLS_ON"), positive = a.integer("SIGN")> 0;
  a.set("CALL_INDEX", synchronised ? 0 : static_cast<std::uint16_t>((index + 1) % calls));
  if (a.flag("STEP3_ON")) return put(a, on && positive, on && !positive);
  put(a, on, !on);
}

}  // namespace merker::system
