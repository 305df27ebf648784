// SFB 41 CONT_C: PID controller with a continuous output (technology manual 7.5.1). What the manual
// leaves open is decided in docs/compatibility.md, "Closed-loop control".
#include <algorithm>
#include <cmath>

#include "system/closed_loop.h"

namespace merker::system {
namespace {

enum {  // clang-format off
  COM_RST, MAN_ON, PVPER_ON, P_SEL, I_SEL, INT_HOLD, I_ITL_ON, D_SEL, CYCLE, SP_INT, PV_IN, PV_PER,
  MAN, GAIN, TI, TD, TM_LAG, DEADB_W, LMN_HLM, LMN_LLM, PV_FAC, PV_OFF, LMN_FAC, LMN_OFF, I_ITLVAL,
  DISV, LMN, LMN_PER, QLMN_HLM, QLMN_LLM, LMN_P, LMN_I, LMN_D, PV, ER, E_OLD, I_OLD, I_REST, D_REST,
  D_FEEDBACK, LMN_LIMITED, AT_HLM, AT_LLM
};  // clang-format on

// PID-CONC-47: outputs at their defaults; the integrator goes on from I_ITLVAL.
void restart(Arguments& a) {
  for (std::size_t i = LMN; i <= AT_LLM; ++i) a.set(i, 0);
  a.set(I_OLD, a.value(I_ITLVAL));
}

// PID-CONC-36: trapezoidal rule; the rest is what adding to a large sum loses.
float integrate(Arguments& a, float e) {
  const float cycle = seconds(a, CYCLE);
  const float time = std::max(seconds(a, TI), 0.5F * cycle);  // PID-CONC-33
  float step = cycle / time * (e + real(a, E_OLD)) * 0.5F + real(a, I_REST);
  const bool windsUp = (step > 0 && a.flag(AT_HLM)) || (step < 0 && a.flag(AT_LLM));
  if (a.flag(INT_HOLD) || windsUp) step = 0;
  const float old = real(a, I_OLD);
  const float sum = old + step;
  setReal(a, I_REST, old - sum + step);
  return sum;
}

float integralPart(Arguments& a, float e, float p) {
  if (a.flag(I_SEL) && !a.flag(I_ITL_ON) && !a.flag(MAN_ON)) return integrate(a, e);
  setReal(a, I_REST, 0);
  if (!a.flag(I_SEL)) return 0;
  if (a.flag(I_ITL_ON)) return real(a, I_ITLVAL);
  return real(a, LMN_LIMITED) - p - real(a, DISV);  // follows, so that automatic begins bumpless
}

// PID-CONC-37: the error less what its lag has fed back.
float derivativePart(Arguments& a, float e) {
  if (a.flag(MAN_ON) || !a.flag(D_SEL)) {
    setReal(a, D_REST, 0);
    setReal(a, D_FEEDBACK, e);
    return 0;
  }
  const float cycle = seconds(a, CYCLE);
  const float time = std::max(seconds(a, TD), cycle);
  const float lag = std::max(seconds(a, TM_LAG), 0.5F * cycle);
  const float old = real(a, D_FEEDBACK);
  const float d = (e - old) * (time / (0.5F * cycle + lag));
  const float step = cycle / time * d + real(a, D_REST);
  const float sum = old + step;
  setReal(a, D_FEEDBACK, sum);
  setReal(a, D_REST, old - sum + step);
  return d;
}

// PID-CONC-42: an integral beyond the limit comes back to it while the sum is beyond it too.
float pulledBack(Arguments& a, float i, float sum) {
  if (a.flag(MAN_ON) || !a.flag(I_SEL) || a.flag(I_ITL_ON)) return i;
  const float disturbance = real(a, DISV), high = real(a, LMN_HLM), low = real(a, LMN_LLM);
  const float withoutD = sum - real(a, LMN_D);  // that of the previous call
  if (i > high - disturbance && sum > high && withoutD > high)
    return i - std::min(i - (high - disturbance), sum - high);
  if (i < low - disturbance && sum < low && withoutD < low)
    return i - std::max(i - (low - disturbance), sum - low);
  return i;
}

// LMNLIMIT (PID-CONC-41)
float limited(Arguments& a, float value) {
  const bool high = value >= real(a, LMN_HLM);
  const bool low = !high && value <= real(a, LMN_LLM);
  a.set(QLMN_HLM, high);
  a.set(QLMN_LLM, low);
  a.set(AT_HLM, high);
  a.set(AT_LLM, low);
  if (high) return real(a, LMN_HLM);
  return low ? real(a, LMN_LLM) : value;
}

// CRP_OUT (PID-CONC-43): rounded half to even, within the overrange of an analog module.
std::uint16_t peripheryValue(float percent) {
  const float value = percent * 276.48F;
  if (std::isnan(value)) return 0;
  return static_cast<std::uint16_t>(std::lrint(std::clamp(value, -32512.0F, 32511.0F)));
}

void putOut(Arguments& a, float sum) {
  const float value = limited(a, sum);
  setReal(a, LMN_LIMITED, value);
  const float lmn = value * real(a, LMN_FAC) + real(a, LMN_OFF);
  setReal(a, LMN, lmn);
  a.set(LMN_PER, peripheryValue(lmn));
}

}  // namespace

void continuousControl(Arguments& a) {
  if (a.flag(COM_RST)) return restart(a);
  if (a.longInteger(CYCLE) <= 0) return;  // PID-OP-08
  const float pv = processValue(a, {PVPER_ON, PV_IN, PV_PER, PV_FAC, PV_OFF});
  const float er = beyondDeadBand(real(a, SP_INT) - pv, real(a, DEADB_W));
  setReal(a, PV, pv);
  setReal(a, ER, er);
  const float e = er * real(a, GAIN);
  const float p = a.flag(P_SEL) ? e : 0.0F;
  const float i = integralPart(a, e, p);
  const float d = derivativePart(a, e);
  const float sum = p + i + d + real(a, DISV);
  const float kept = pulledBack(a, i, sum);
  setReal(a, LMN_P, p);
  setReal(a, LMN_I, kept);
  setReal(a, LMN_D, d);
  setReal(a, E_OLD, e);
  setReal(a, I_OLD, kept);
  putOut(a, a.flag(MAN_ON) ? real(a, MAN) : sum);
}

}  // namespace merker::system
