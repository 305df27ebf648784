// What the controllers SFB 41 and 42 have in common: times, process value and error. Every
// operation is one of IEEE 754 single precision, in the order of the block diagram.
#pragma once

#include "system/call.h"

namespace merker::system {

inline float seconds(std::int32_t milliseconds) {
  return static_cast<float>(milliseconds) / 1000.0F;
}
template <typename A>
float seconds(A& a, NameIn<A> parameter) {
  return seconds(a.longInteger(parameter));
}

// CRP_IN and PV_NORM (technology manual 7.5.1; PID-CONC-30, -31).
template <typename A>
float processValue(A& a) {
  if (!a.flag("PVPER_ON")) return a.real("PV_IN");
  const float percent = static_cast<float>(a.integer("PV_PER")) * 100.0F / 27648.0F;
  return percent * a.real("PV_FAC") + a.real("PV_OFF");
}

// The error, less the width of the dead band (PID-CONC-32).
inline float beyondDeadBand(float difference, float width) {
  if (difference < -width) return difference + width;
  if (difference > width) return difference - width;
  return difference == difference ? 0.0F : difference;  // NaN stays (PID-CONC-49)
}

// The error beyond the dead band times GAIN; PV and ER show what it was made of.
template <typename A>
float amplifiedError(A& a) {
  const float pv = processValue(a);
  const float er = beyondDeadBand(a.real("SP_INT") - pv, a.real("DEADB_W"));
  a.setReal("PV", pv);
  a.setReal("ER", er);
  return er * a.real("GAIN");
}

}  // namespace merker::system
