// What the controllers SFB 41 and 42 have in common: REAL parameters, times, process value and
// error. Every operation is one of IEEE 754 single precision, in the order of the block diagram.
#pragma once

#include <bit>

#include "system/arguments.h"

namespace merker::system {

inline float real(Arguments& a, std::size_t i) { return std::bit_cast<float>(a.value(i)); }
inline void setReal(Arguments& a, std::size_t i, float value) {
  a.set(i, std::bit_cast<std::uint32_t>(value));
}
inline float seconds(std::int32_t milliseconds) {
  return static_cast<float>(milliseconds) / 1000.0F;
}
inline float seconds(Arguments& a, std::size_t i) { return seconds(a.longInteger(i)); }

// The parameters by their numbers in the rows.
struct ProcessValue {
  std::size_t fromPeriphery, floating, periphery, factor, offset;
};

// CRP_IN and PV_NORM (technology manual 7.5.1; PID-CONC-30, -31).
inline float processValue(Arguments& a, const ProcessValue& p) {
  if (!a.flag(p.fromPeriphery)) return real(a, p.floating);
  const float percent = static_cast<float>(a.integer(p.periphery)) * 100.0F / 27648.0F;
  return percent * real(a, p.factor) + real(a, p.offset);
}

// The error, less the width of the dead band (PID-CONC-32).
inline float beyondDeadBand(float difference, float width) {
  if (difference < -width) return difference + width;
  if (difference > width) return difference - width;
  return difference == difference ? 0.0F : difference;  // NaN stays (PID-CONC-49)
}

}  // namespace merker::system
