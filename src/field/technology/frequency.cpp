#include "technology/frequency.h"

#include <algorithm>

namespace merker::technology {
namespace {

constexpr std::uint16_t kInvalidJob = 0x02FF;

// mHz of so many periods in a length of time, rounded.
std::int32_t millihertz(std::int64_t periods, Duration length) {
  constexpr std::int64_t kPerSecond = 1'000'000'000'000;
  return static_cast<std::int32_t>((kPerSecond * periods + length.ns / 2) / length.ns);
}

}  // namespace

void Frequency::start(bool gateLevel, Instant) {
  const io::CountChannel parameters = p_;
  *this = Frequency(parameters, highest_);
  gate_.used = p_.hardwareGate;
  gate_.hardware = gateLevel;
}

void Frequency::stop() {
  gate_.software = softwareEdge_.last = false;
  windowEnd_ = Instant::never();
  manual_ = set_ = above_ = below_ = false;
}

bool Frequency::watched() const {
  return ownsOutput() || p_.onGateOpened || p_.onGateClosed || p_.onLowLimit || p_.onHighLimit ||
         p_.onMeasured;
}

void Frequency::opened(Instant at) {
  value_ = -1;
  count_ = 0;
  window_ = Duration::milliseconds(p_.integrationTime);
  windowEnd_ = at + window_;
  reference_ = last_ = Instant::never();
  pulses_ = 0;
  lastMeasured_ = emptyWindows_ = 0;
}

// The value stays when the gate closes (CNT-FREQ-12).
void Frequency::gateChanged(bool before, Instant at) {
  if (before == gate_.open()) return;
  if (gate_.open())
    opened(at);
  else
    windowEnd_ = Instant::never();
}

void Frequency::gateEdge(bool level, Instant at) {
  const bool before = gate_.open();
  gate_.hardware = level;
  gateChanged(before, at);
  if (gate_.used)
    raise(gate_.software && (level ? p_.onGateOpened : p_.onGateClosed),
          level ? io::kGateOpened : io::kGateClosed);
}

void Frequency::control(bool softwareGate, bool manual, bool set, Instant now) {
  const bool before = gate_.open();
  if (softwareEdge_.rises(softwareGate)) gate_.software = true;
  if (!softwareGate) gate_.software = false;
  gateChanged(before, now);
  manual_ = manual;
  set_ = set;
}

void Frequency::pulse(int direction, Instant at) {
  direction_ = direction;
  if (!gate_.open()) return;
  count_ += direction;
  if (reference_ == Instant::never())
    reference_ = at;
  else
    ++pulses_;
  last_ = at;
}

std::uint64_t Frequency::absorbs(int) const {
  return gate_.open() && reference_ == Instant::never() ? 0 : kUnlimited;
}

void Frequency::absorb(int direction, std::uint64_t pulses, Instant last, Instant) {
  direction_ = direction;
  if (!gate_.open()) return;
  count_ = static_cast<std::int32_t>(count_ + direction * static_cast<std::int64_t>(pulses));
  pulses_ += static_cast<std::int64_t>(pulses);
  last_ = last;
}

// Whole periods only (CNT-FREQ-05). Windows without a pulse: 0, or the last value divided by their
// number (CNT-FREQ-07, -08).
std::int32_t Frequency::evaluate() {
  if (pulses_ > 0) {
    const Duration length = last_ - reference_;
    const bool slow = pulses_ == 1 && length > window_ && !p_.averaged;
    const std::int32_t value = millihertz(pulses_, length);
    reference_ = last_;
    pulses_ = 0;
    emptyWindows_ = 0;
    lastMeasured_ = value;
    return slow ? 0 : value;
  }
  if (!p_.averaged || lastMeasured_ == 0) return 0;
  ++emptyWindows_;
  return std::max(lastMeasured_ / emptyWindows_, 1);
}

// The order of CNT-FREQ-16.
void Frequency::expire(Instant at) {
  value_ = evaluate();
  measured_ = true;
  checkLimits();
  raise(p_.onMeasured, io::kMeasured);
  window_ = Duration::milliseconds(p_.integrationTime);
  windowEnd_ = at + window_;
}

// An interrupt on entering only (CNT-PRAL-10).
void Frequency::checkLimits() {
  const bool above = value_ > p_.highLimit, below = value_ < p_.lowLimit;
  raise((above && !above_ && p_.onHighLimit) || (below && !below_ && p_.onLowLimit), io::kLimit);
  above_ = above;
  below_ = below;
  overflow_ = overflow_ || above;
  underflow_ = underflow_ || below;
}

bool Frequency::compared() const {
  switch (p_.limitOutput) {
    case io::LimitOutput::Outside:
      return above_ || below_;
    case io::LimitOutput::Below:
      return below_;
    case io::LimitOutput::Above:
      return above_;
    case io::LimitOutput::None:
      return false;
  }
  return false;
}

void Frequency::resetStatus() {
  measured_ = false;
  overflow_ = above_;
  underflow_ = below_;
}

// CNT-JOB-11, -12; a low limit that is not below the high one is one too large, and the reverse.
JobResult Frequency::job(std::uint32_t id, std::int32_t value) {
  JobResult result;
  const auto accept = [&](const JobRange& range, std::int32_t& target) {
    result.error = range.check(value);
    if (result.error == 0) target = value;
  };
  const auto shows = [](std::int32_t read) { return JobResult{0, true, read}; };
  switch (id) {
    case 0x00:
      break;
    case 0x01:
      accept({0, std::int64_t{p_.highLimit} - 1, 0x0231}, p_.lowLimit);
      break;
    case 0x02:
      accept({std::int64_t{p_.lowLimit} + 1, highest_, 0x0241}, p_.highLimit);
      break;
    case 0x04:
      accept({10, 10'000, 0x0221}, p_.integrationTime);
      break;
    case 0x81:
      return shows(p_.lowLimit);
    case 0x82:
      return shows(p_.highLimit);
    case 0x84:
      return shows(p_.integrationTime);
    default:
      result.error = kInvalidJob;
  }
  return result;
}

}  // namespace merker::technology
