#include "technology/pulse_width.h"

#include <algorithm>
#include <tuple>

namespace merker::technology {
namespace {

constexpr std::int32_t kPerMille = 1000, kAnalog = 27'648;  // full output value
constexpr std::uint16_t kInvalidJob = 0x04FF;
constexpr std::int64_t kMicrosecond = 1000;  // ns

}  // namespace

void PulseWidth::start(bool, Instant) {
  const io::CountChannel parameters = p_;
  *this = PulseWidth(parameters);
}

void PulseWidth::stop() {
  phase_ = Phase::Stopped;
  software_ = softwareEdge_.last = manual_ = set_ = false;
}

// Whole microseconds. What is shorter than the minimum pulse is left out (CNT-PWM-03, -04, -05).
void PulseWidth::calculate() {
  const Duration period = unit() * p_.period;
  const std::int64_t full = p_.analogFormat ? kAnalog : kPerMille;
  const Duration least =
      p_.minimumPulse == 0 ? Duration::microseconds(200) : unit() * p_.minimumPulse;
  const std::int64_t pulse = period.ns * std::clamp<std::int64_t>(value_, 0, full) / full;
  high_ = Duration{pulse / kMicrosecond * kMicrosecond};
  if (high_ < least) high_ = {};
  if (period - high_ < least) high_ = period;
  low_ = period - high_;
}

Duration PulseWidth::length() const {
  switch (phase_) {
    case Phase::Delay:
      return unit() * p_.onDelay;
    case Phase::Pulse:
      return high_;
    default:
      return low_;
  }
}

// Phases end when their time is over, at once if it is over already (CNT-PWM-10 to -13).
void PulseWidth::tick(Instant at) {
  while (running() && since_ + length() <= at) {
    since_ = at;
    phase_ = phase_ == Phase::Pulse ? Phase::Pause : Phase::Pulse;
  }
}

void PulseWidth::begin(Instant at) {
  phase_ = Phase::Delay;
  since_ = at;
  tick(at);
}

Instant PulseWidth::due() const { return running() ? since_ + length() : Instant::never(); }

bool PulseWidth::output() const { return manual_ ? set_ : phase_ == Phase::Pulse && high_.ns > 0; }

// With the hardware gate: first the software gate, then a rising edge starts; the level does not
// matter afterwards (CNT-PWM-07).
void PulseWidth::gateEdge(bool level, Instant at) {
  if (!p_.hardwareGate || !level || !software_) return;
  raise(p_.onGateOpened, io::kGateOpened);
  if (!running()) begin(at);
}

void PulseWidth::control(bool enable, bool manual, bool set, std::int32_t output, Instant now) {
  changed_ |=
      std::tie(enable, manual, set, output) != std::tie(softwareEdge_.last, manual_, set_, value_);
  value_ = output;
  calculate();
  const bool rises = softwareEdge_.rises(enable);
  software_ = enable && (software_ || rises);
  if (!enable) phase_ = Phase::Stopped;
  if (rises && !p_.hardwareGate) begin(now);
  manual_ = manual;
  set_ = set;
  tick(now);
}

// CNT-JOB-13, -14
JobResult PulseWidth::job(std::uint32_t id, std::int32_t value, Instant now) {
  JobResult result;
  const auto accept = [&](const JobRange& range, std::int32_t& target) {
    result.error = range.check(value);
    if (result.error != 0) return;
    target = value;
    changed_ = true;
    calculate();
    tick(now);
  };
  const auto shows = [](std::int32_t read) { return JobResult{0, true, read}; };
  switch (id) {
    case 0x00:
      break;
    case 0x01:
      accept({std::max(p_.milliseconds ? 1 : 4, 2 * p_.minimumPulse), 65'535, 0x0411}, p_.period);
      break;
    case 0x02:
      accept({0, 65'535, 0x0421}, p_.onDelay);
      break;
    case 0x04:
      accept({p_.milliseconds ? 0 : 2, p_.period / 2, 0x0431}, p_.minimumPulse);
      break;
    case 0x81:
      return shows(p_.period);
    case 0x82:
      return shows(p_.onDelay);
    case 0x83:  // printed in 5.7.3 (docs/errata.md)
    case 0x84:
      return shows(p_.minimumPulse);
    default:
      result.error = kInvalidJob;
  }
  return result;
}

}  // namespace merker::technology
