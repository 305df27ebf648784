// SFB 41 CONT_C: PID controller with a continuous output (technology manual 7.5.1). What the manual
// leaves open is decided in docs/compatibility.md, "Closed-loop control".
#include <algorithm>
#include <cmath>

#include "system/closed_loop.h"

namespace merker::system {
namespace {

// PID-CONC-47: outputs at their defaults; the integrator goes on from I_ITLVAL.
void restart(Sfb<41>& a) {
  a.clear("LMN", "AT_LLM");
  a.set("I_OLD", a.value("I_ITLVAL"));
}

// PID-CONC-36: trapezoidal rule; the rest is what adding to a large sum loses.
float integrate(Sfb<41>& a, float e) {
  const float cycle = seconds(a, "CYCLE");
  const float time = std::max(seconds(a, "TI"), 0.5F * cycle);  // PID-CONC-33
  float step = cycle / time * (e + a.real("E_OLD")) * 0.5F + a.real("I_REST");
  const bool windsUp = (step > 0 && a.flag("AT_HLM")) || (step < 0 && a.flag("AT_LLM"));
  if (a.flag("INT_HOLD") || windsUp) step = 0;
  const float old = a.real("I_OLD");
  const float sum = old + step;
  a.setReal("I_REST", old - sum + step);
  return sum;
}

float integralPart(Sfb<41>& a, float e, float p) {
  if (a.flag("I_SEL") && !a.flag("I_ITL_ON") && !a.flag("MAN_ON")) return integrate(a, e);
  a.setReal("I_REST", 0);
  if (!a.flag("I_SEL")) return 0;
  if (a.flag("I_ITL_ON")) return a.real("I_ITLVAL");
  return a.real("LMN_LIMITED") - p - a.real("DISV");  // follows, so that automatic begins bumpless
}

// PID-CONC-37: the error less what its lag has fed back.
float derivativePart(Sfb<41>& a, float e) {
  if (a.flag("MAN_ON") || !a.flag("D_SEL")) {
    a.setReal("D_REST", 0);
    a.setReal("D_FEEDBACK", e);
    return 0;
  }
  const float cycle = seconds(a, "CYCLE");
  const float time = std::max(seconds(a, "TD"), cycle);
  const float lag = std::max(seconds(a, "TM_LAG"), 0.5F * cycle);
  const float old = a.real("D_FEEDBACK");
  const float d = (e - old) * (time / (0.5F * cycle + lag));
  const float step = cycle / time * d + a.real("D_REST");
  const float sum = old + step;
  a.setReal("D_FEEDBACK", sum);
  a.setReal("D_REST", old - sum + step);
  return d;
}

// PID-CONC-42: an integral beyond the limit comes back to it while the sum is beyond it too.
float pulledBack(Sfb<41>& a, float i, float sum) {
  if (a.flag("MAN_ON") || !a.flag("I_SEL") || a.flag("I_ITL_ON")) return i;
  const float disturbance = a.real("DISV"), high = a.real("LMN_HLM"), low = a.real("LMN_LLM");
  const float withoutD = sum - a.real("LMN_D");  // that of the previous call
  if (i > high - disturbance && sum > high && withoutD > high)
    return i - std::min(i - (high - disturbance), sum - high);
  if (i < low - disturbance && sum < low && withoutD < low)
    return i - std::max(i - (low - disturbance), sum - low);
  return i;
}

// LMNLIMIT (PID-CONC-41)
float limited(Sfb<41>& a, float value) {
  const bool high = value >= a.real("LMN_HLM");
  const bool low = !high && value <= a.real("LMN_LLM");
  a.set("QLMN_HLM", high);
  a.set("QLMN_LLM", low);
  a.set("AT_HLM", high);
  a.set("AT_LLM", low);
  if (high) return a.real("LMN_HLM");
  return low ? a.real("LMN_LLM") : value;
}

// CRP_OUT (PID-CONC-43): rounded half to even, within the overrange of an analog module.
std::uint16_t peripheryValue(float percent) {
  const float value = percent * 276.48F;
  if (std::isnan(value)) return 0;
  return static_cast<std::uint16_t>(std::lrint(std::clamp(value, -32512.0F, 32511.0F)));
}

void putOut(Sfb<41>& a, float sum) {
  const float value = limited(a, sum);
  a.setReal("LMN_LIMITED", value);
  const float lmn = value * a.real("LMN_FAC") + a.real("LMN_OFF");
  a.setReal("LMN", lmn);
  a.set("LMN_PER", peripheryValue(lmn));
}

}  // namespace

void continuousControl(Sfb<41>& a) {
  if (a.flag("COM_RST")) return restart(a);
  if (a.longInteger("CYCLE") <= 0) return;  // PID-OP-08
  const float e = amplifiedError(a);
  const float p = a.flag("P_SEL") ? e : 0.0F;
  const float i = integralPart(a, e, p);
  const float d = derivativePart(a, e);
  const float sum = p + i + d + a.real("DISV");
  const float kept = pulledBack(a, i, sum);
  a.setReal("LMN_P", p);
  a.setReal("LMN_I", kept);
  a.setReal("LMN_D", d);
  a.setReal("E_OLD", e);
  a.setReal("I_OLD", kept);
  putOut(a, a.flag("MAN_ON") ? a.real("MAN") : sum);
}

}  // namespace merker::system
