#include "positioning/target.h"

#include <cstdlib>

#include "positioning/error.h"
#include "positioning/position.h"

namespace merker::positioning {
namespace {

int directionOf(const Request& request) { return request.plus ? 1 : -1; }

std::int64_t cutOff(const Course& course) {
  return course.motion.differences.of(course.direction).cutOff;
}

std::int64_t way(const Course& course, const Situation& now) {
  return course.direction * (*course.target - now.position);
}

// Up to half of the target range there is nothing to travel (POS-RUN-26).
Decision travelled(const io::AxisChannel& axis, const Situation& now, Plan plan) {
  const std::int64_t pulses = way(plan.course, now);
  plan.travels = std::abs(pulses) > halfRange(axis);
  if (plan.travels && pulses < cutOff(plan.course))
    return std::uint16_t{plan.course.direction > 0 ? kWayTooShortPlus : kWayTooShortMinus};
  return plan;
}

// The target of a linear axis with its range, and with the distance that is left of the last run.
std::uint16_t targetError(const io::AxisChannel& axis, const Situation& now, std::int64_t target) {
  const std::int64_t half = halfRange(axis);
  const bool inside = withinLimits(axis, target - half) && withinLimits(axis, target + half);
  if (limited(axis, now.synchronous) && !inside) return kTargetRangeOutside;
  const std::int64_t sum = target + now.lastTarget - now.position;
  if (sum < -kTravelLimit) return kWayTooLongMinus;
  return sum > kTravelLimit ? kWayTooLongPlus : kNoError;
}

// The last position that can be approached in a direction (POS-JOG-10).
std::optional<std::int64_t> lastTarget(const io::AxisChannel& axis, bool synchronous,
                                       int direction) {
  if (axis.rotary) return std::nullopt;
  if (!limited(axis, synchronous)) return direction * kTravelLimit;
  return direction > 0 ? axis.highLimit : axis.lowLimit;
}

Decision endless(const Situation& now, Plan plan) {
  if (plan.course.target && way(plan.course, now) <= cutOff(plan.course))
    return std::uint16_t{plan.course.direction > 0 ? kLimitTooClosePlus : kLimitTooCloseMinus};
  return plan;
}

// The shortest way; the other one if it is too short to be travelled (POS-INCA-04 to -07).
int shortest(const io::AxisChannel& axis, const Motion& motion, std::int64_t plusWay) {
  const std::int64_t minusWay = axis.rotaryEnd - plusWay;
  const int direction = plusWay <= minusWay ? 1 : -1;
  const std::int64_t shorter = direction > 0 ? plusWay : minusWay;
  const bool tooShort = shorter <= motion.differences.of(direction).cutOff;
  return tooShort && shorter > halfRange(axis) ? -direction : direction;
}

// The target on the way of this run, over the end of the axis if need be (POS-INCA-10).
Decision onCircle(const io::AxisChannel& axis, const Situation& now, const Request& request) {
  if (request.target < 0 || request.target >= axis.rotaryEnd) return std::uint16_t{kWrongTarget};
  const std::int64_t plusWay = shown(request.target - now.position, axis);
  const int direction =
      request.start ? shortest(axis, request.motion, plusWay) : directionOf(request);
  const std::int64_t minusWay = plusWay == 0 ? 0 : axis.rotaryEnd - plusWay;
  const std::int64_t target = now.position + (direction > 0 ? plusWay : -minusWay);
  return travelled(axis, now,
                   {Mode::Absolute, {direction, request.motion, target}, {}, now.position});
}

}  // namespace

Decision jog(const io::AxisChannel& axis, const Situation& now, const Request& request) {
  const int direction = directionOf(request);
  return endless(now, {Mode::Jog,
                       {direction, request.motion, lastTarget(axis, now.synchronous, direction)},
                       {},
                       now.position});
}

// Without synchronisation there are no software limit switches (POS-REF-12).
Decision reference(const io::AxisChannel& axis, const Situation& now, const Request& request) {
  const int location = axis.referenceBelowSwitch ? -1 : 1;
  const int direction = now.onSwitch ? location : directionOf(request);
  return endless(now, {Mode::Reference,
                       {direction, request.motion, lastTarget(axis, false, direction)},
                       {location, request.motion, lastTarget(axis, false, location)},
                       now.position});
}

// From the last target, not from the position (POS-INCR-01).
Decision relative(const io::AxisChannel& axis, const Situation& now, const Request& request) {
  if (request.target < 0) return std::uint16_t{kNegativeDistance};
  const int direction = directionOf(request);
  const std::int64_t target = now.lastTarget + direction * std::int64_t{request.target};
  if (!axis.rotary) {
    if (target <= -kTravelLimit) return std::uint16_t{kTargetTooLow};
    if (target >= kTravelLimit) return std::uint16_t{kTargetTooHigh};
    if (const std::uint16_t error = targetError(axis, now, target)) return error;
  }
  return travelled(axis, now,
                   {Mode::Relative, {direction, request.motion, target}, {}, now.lastTarget});
}

Decision absolute(const io::AxisChannel& axis, const Situation& now, const Request& request) {
  if (axis.rotary) return onCircle(axis, now, request);
  const std::int64_t target = request.target;
  if (!withinLimits(axis, target)) return std::uint16_t{kTargetOutside};
  if (const std::uint16_t error = targetError(axis, now, target)) return error;
  const int direction = target >= now.position ? 1 : -1;
  return travelled(axis, now,
                   {Mode::Absolute, {direction, request.motion, target}, {}, now.position});
}

Decision continued(const io::AxisChannel& axis, const Situation& now, const Request& request) {
  const Interrupted& run = *now.interrupted;
  const bool onward = directionOf(request) == run.course.direction;
  const std::int64_t target = onward ? *run.course.target : run.startPoint;
  const std::int64_t start = onward ? run.startPoint : *run.course.target;
  return travelled(axis, now,
                   {Mode::Relative, {directionOf(request), run.course.motion, target}, {}, start});
}

}  // namespace merker::positioning
