#include "positioning/soundness.h"

#include <algorithm>
#include <iterator>

#include "positioning/motion.h"

namespace merker::positioning {
namespace {

using io::AxisChannel;

bool within(std::int64_t value, std::int64_t low, std::int64_t high) {
  return value >= low && value <= high;
}

bool isFrequency(std::uint32_t kilohertz) {
  constexpr std::uint32_t kFrequencies[] = {60, 30, 10, 5, 2, 1};
  return std::find(std::begin(kFrequencies), std::end(kFrequencies), kilohertz) !=
         std::end(kFrequencies);
}

bool analog(const AxisChannel& a) { return a.output == io::AxisOutput::Analog; }

bool targetRangeFits(const AxisChannel& a) {  // POS-PARAM-03
  const std::int64_t range = 2 * halfRange(a);
  return a.rotary ? range <= a.rotaryEnd : range <= std::int64_t{a.highLimit} - a.lowLimit;
}

bool referenceFits(const AxisChannel& a) {  // POS-PARAM-19
  return a.rotary ? within(a.reference, 0, std::int64_t{a.rotaryEnd} - 1)
                  : within(a.reference, a.lowLimit, a.highLimit);
}

bool limitsFit(const AxisChannel& a) {
  return within(a.lowLimit, -kTravelLimit, kTravelLimit) &&
         within(a.highLimit, -kTravelLimit, kTravelLimit);
}

struct Condition {
  bool (*holds)(const AxisChannel&);
  std::string_view text;
};

constexpr std::int32_t kLongest = 100'000;  // ms

// In the order of POS-PARAM; where a rule is of one kind of axis or output, it holds for the
// others.
constexpr Condition kConditions[] = {
    {[](const AxisChannel& a) { return within(a.targetRange, 0, 200'000'000); },
     "the target range must be 0 to 200000000 pulses"},
    {[](const AxisChannel& a) { return within(a.monitoringTime, 0, kLongest); },
     "the monitoring time must be 0 to 100000 ms"},
    {[](const AxisChannel& a) { return !analog(a) || within(a.highestSpeed, 10, 1'000'000); },
     "the maximum speed must be 10 to 1000000 pulses/s"},
    {[](const AxisChannel& a) { return !analog(a) || within(a.creepSpeed, 10, a.highestSpeed); },
     "the creep speed must be 10 pulses/s up to the maximum speed"},
    {[](const AxisChannel& a) { return !analog(a) || within(a.cutOffDelay, 0, kLongest); },
     "the cut-off delay must be 0 to 100000 ms"},
    {[](const AxisChannel& a) {
       return isFrequency(a.maxFrequency) && isFrequency(a.accompanyingFrequency);
     },
     "a maximum frequency must be 60, 30, 10, 5, 2 or 1 kHz"},
    {[](const AxisChannel& a) { return within(a.digitalControl, 1, 4); },
     "the control type must be 1 to 4"},
    {[](const AxisChannel& a) { return a.rotary || limitsFit(a); },
     "a software limit switch must be -500000000 to 500000000 pulses"},
    {[](const AxisChannel& a) { return a.rotary || a.lowLimit < a.highLimit; },
     "the software limit switch at the start must be less than the one at the end"},
    {[](const AxisChannel& a) { return !a.rotary || within(a.rotaryEnd, 1, 1'000'000'000); },
     "the end of the rotary axis must be 1 to 1000000000 pulses"},
    {referenceFits, "the reference point must be on the axis, between the software limit switches"},
    {targetRangeFits, "the target range must not be larger than the range of the axis"},
    {[](const AxisChannel& a) { return within(a.increments, 1, 1 << 23); },
     "the increments of an encoder revolution must be 1 to 8388608"},
};

}  // namespace

std::optional<std::string_view> flaw(const AxisChannel& axis) {
  for (const Condition& condition : kConditions)
    if (!condition.holds(axis)) return condition.text;
  return std::nullopt;
}

}  // namespace merker::positioning
