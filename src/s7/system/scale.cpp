// FC 105 SCALE, FC 106 UNSCALE (S7-IEC-09).
#include <algorithm>
#include <cmath>

#include "system/call.h"

namespace merker::system {
namespace {

constexpr float kHigh = 27648.0f;
constexpr std::uint32_t kOutside = 8;

template <typename A>
float low(A& a) {
  return a.flag("BIPOLAR") ? -kHigh : 0.0f;
}

// RET_VAL 8 and BIE 0 when the input lies outside; the output is then its limit.
void finish(Arguments& a, bool inside) {
  a.status(inside ? 0 : kOutside);
  if (!inside) a.fail();
}

}  // namespace

void scaleValue(Fc<105>& a) {
  const auto in = static_cast<float>(a.integer("IN"));
  const float k1 = low(a), k2 = kHigh, high = a.real("HI_LIM"), bottom = a.real("LO_LIM");
  const float limited = std::clamp(in, k1, k2);
  a.setReal("OUT", (limited - k1) / (k2 - k1) * (high - bottom) + bottom);
  finish(a, limited == in);
}

void unscaleValue(Fc<106>& a) {
  const float in = a.real("IN"), high = a.real("HI_LIM"), bottom = a.real("LO_LIM");
  const float k1 = low(a), k2 = kHigh;
  const float limited = std::fmax(std::fmin(in, std::fmax(high, bottom)), std::fmin(high, bottom));
  const float span = high - bottom;
  const float out = span == 0.0f ? k1 : (limited - bottom) / span * (k2 - k1) + k1;
  a.set("OUT", static_cast<std::uint16_t>(std::lround(std::isfinite(out) ? out : k1)));
  finish(a, limited == in && span != 0.0f);
}

}  // namespace merker::system
