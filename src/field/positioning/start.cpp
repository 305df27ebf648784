#include "positioning/start.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "positioning/error.h"
#include "positioning/target.h"

namespace merker::positioning {
namespace {

bool is(const Request& request, Mode mode) {
  return request.mode == static_cast<std::int32_t>(mode);
}

bool known(const Request& request) {
  constexpr Mode kModes[] = {Mode::Jog, Mode::Reference, Mode::Relative, Mode::Absolute};
  return std::any_of(std::begin(kModes), std::end(kModes),
                     [&](Mode mode) { return is(request, mode); });
}

std::uint16_t generalError(const io::AxisChannel& axis, const Situation& now,
                           const Request& request) {
  if (request.jobFailed) return kJobFailed;
  if (!known(request)) return kUnknownMode;
  if (now.working && !is(request, now.active)) return kModeChanged;
  const bool direction = request.plus || request.minus;
  const bool both = request.plus && request.minus;
  if (both || (request.start && direction)) return kSeveralStarts;
  if (request.start && !is(request, Mode::Absolute)) return kStartNotAllowed;
  if (direction && is(request, Mode::Absolute) && !axis.rotary) return kDirectionNotAllowed;
  return kNoError;
}

// What ST_ENBLD sums up (POS-RUN-28).
std::uint16_t enableError(const io::AxisChannel&, const Situation& now, const Request& request) {
  if (!now.parametrised) return kNotParametrised;
  if (!now.driveEnabled) return kNoDriveEnable;
  if (now.stopped) return kStopSet;
  if (now.working && !is(request, Mode::Jog)) return kPositioning;
  return now.errors != 0 ? kErrorPending : kNoError;
}

std::uint16_t stateError(const io::AxisChannel& axis, const Situation& now,
                         const Request& request) {
  if (is(request, Mode::Absolute) && !now.synchronous) return kNotSynchronised;
  const bool left = limited(axis, now.synchronous) && !withinLimits(axis, now.position);
  return left && !is(request, Mode::Jog) ? kOutsideWorkingRange : kNoError;
}

std::uint16_t speedError(const io::AxisChannel& axis, const Situation&, const Request& request) {
  if (axis.output == io::AxisOutput::Digital) return kNoError;
  constexpr std::int32_t kFastest = 100'000;  // pulses/s^2
  const Motion& motion = request.motion;
  const bool slow = motion.speed < axis.creepSpeed, reference = is(request, Mode::Reference);
  if (motion.speed > axis.highestSpeed || (slow && !reference)) return kWrongSpeed;
  if (motion.acceleration < 1 || motion.acceleration > kFastest) return kWrongAcceleration;
  if (motion.deceleration < 1 || motion.deceleration > kFastest) return kWrongDeceleration;
  return slow ? kBelowReferenceSpeed : kNoError;  // POS-REF-17
}

// POS-RUN-24, POS-RUN-25; those of both directions, a run may turn.
std::uint16_t differenceError(const io::AxisChannel& axis, const Situation&,
                              const Request& request) {
  constexpr std::int32_t kLargest = 100'000'000;
  const auto invalid = [](std::int32_t value) { return value < 0 || value > kLargest; };
  const bool analog = axis.output == io::AxisOutput::Analog;
  const std::int64_t half = halfRange(axis);
  const Differences sides[] = {request.motion.differences.plus, request.motion.differences.minus};
  for (const Differences& side : sides)
    if (invalid(side.changeover) || invalid(side.cutOff)) return kDifferenceTooLarge;
  for (const Differences& side : sides)
    if (!analog && side.changeover < side.cutOff) return kChangeoverBelowCutOff;
  for (const Differences& side : sides)
    if (side.cutOff < half) return kCutOffTooSmall;
  for (const Differences& side : sides)
    if (side.changeover < half) return kChangeoverTooSmall;
  return kNoError;
}

using Rule = std::uint16_t (*)(const io::AxisChannel&, const Situation&, const Request&);
constexpr Rule kStates[] = {generalError, enableError, stateError};
constexpr Rule kParameters[] = {speedError, differenceError};

std::uint16_t firstError(std::span<const Rule> rules, const io::AxisChannel& axis,
                         const Situation& now, const Request& request) {
  for (const Rule rule : rules)
    if (const std::uint16_t error = rule(axis, now, request); error != kNoError) return error;
  return kNoError;
}

}  // namespace

bool limited(const io::AxisChannel& axis, bool synchronous) {
  return !axis.rotary && synchronous && axis.monitors.workingRange;
}

bool withinLimits(const io::AxisChannel& axis, std::int64_t position) {
  return position >= axis.lowLimit && position <= axis.highLimit;
}

// A run that goes on with mode 4 takes everything from the interrupted one (POS-INCR-09, -10).
Decision decide(const io::AxisChannel& axis, const Situation& now, const Request& request) {
  if (const std::uint16_t error = firstError(kStates, axis, now, request)) return error;
  if (is(request, Mode::Relative) && now.interrupted) return continued(axis, now, request);
  if (const std::uint16_t error = firstError(kParameters, axis, now, request)) return error;
  switch (static_cast<Mode>(request.mode)) {
    case Mode::Jog:
      return jog(axis, now, request);
    case Mode::Reference:
      return reference(axis, now, request);
    case Mode::Relative:
      return relative(axis, now, request);
    case Mode::Absolute:
      return absolute(axis, now, request);
    case Mode::None:
      break;
  }
  return std::uint16_t{kUnknownMode};
}

}  // namespace merker::positioning
