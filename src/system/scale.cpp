// FC 105 SCALE, FC 106 UNSCALE (S7-IEC-09).
#include <algorithm>
#include <bit>
#include <cmath>

#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr float kHigh = 27648.0f;
constexpr std::uint32_t kOutside = 8;

float real(Arguments& a, std::size_t i) { return std::bit_cast<float>(a.value(i)); }
void setReal(Arguments& a, std::size_t i, float value) {
  a.set(i, std::bit_cast<std::uint32_t>(value));
}
float low(Arguments& a, std::size_t bipolar) { return a.flag(bipolar) ? -kHigh : 0.0f; }

// RET_VAL 8 and BIE 0 when the input lies outside; the output is then its limit.
void finish(Arguments& a, bool inside) {
  a.status(inside ? 0 : kOutside);
  if (!inside) a.fail();
}

}  // namespace

void scaleValue(Arguments& a) {
  enum { IN, HI_LIM, LO_LIM, BIPOLAR, OUT };
  const auto in = static_cast<float>(a.integer(IN));
  const float k1 = low(a, BIPOLAR), k2 = kHigh, high = real(a, HI_LIM), bottom = real(a, LO_LIM);
  const float limited = std::clamp(in, k1, k2);
  setReal(a, OUT, (limited - k1) / (k2 - k1) * (high - bottom) + bottom);
  finish(a, limited == in);
}

void unscaleValue(Arguments& a) {
  enum { IN, HI_LIM, LO_LIM, BIPOLAR, OUT };
  const float in = real(a, IN), high = real(a, HI_LIM), bottom = real(a, LO_LIM);
  const float k1 = low(a, BIPOLAR), k2 = kHigh;
  const float limited = std::fmax(std::fmin(in, std::fmax(high, bottom)), std::fmin(high, bottom));
  const float span = high - bottom;
  const float out = span == 0.0f ? k1 : (limited - bottom) / span * (k2 - k1) + k1;
  a.set(OUT, static_cast<std::uint16_t>(std::lround(std::isfinite(out) ? out : k1)));
  finish(a, limited == in && span != 0.0f);
}

}  // namespace merker::system
