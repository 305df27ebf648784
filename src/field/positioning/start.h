// What becomes of a start request: a course, or the number of the first rule that it breaks
// (POS-RUN-36).
#pragma once

#include <optional>
#include <variant>

#include "positioning/run.h"

namespace merker::positioning {

struct Request {
  std::int32_t mode = 0;  // MODE_IN
  bool start = false, plus = false, minus = false;
  std::int32_t target = 0;
  Motion motion;
  bool jobFailed = false;  // of the same call
};

// A run with a target that STOP ended before its cut-off point (POS-END-12).
struct Interrupted {
  Course course;
  std::int64_t startPoint = 0;
};

// What a start depends on beside the request.
struct Situation {
  bool parametrised = false, driveEnabled = false, stopped = false;
  bool working = false, synchronous = false, onSwitch = false;
  Mode active = Mode::None;
  std::uint16_t errors = 0;
  std::int64_t position = 0, lastTarget = 0;
  std::optional<Interrupted> interrupted;
};

struct Plan {
  Mode mode = Mode::None;
  Course course;
  Course back;  // reference-point run: behind the switch
  std::int64_t startPoint = 0;
  bool travels = true;  // false: the axis is at the target (POS-INCR-05)
};

using Decision = std::variant<std::uint16_t, Plan>;
Decision decide(const io::AxisChannel& axis, const Situation& now, const Request& request);

// Whether the software limit switches hold (POS-PARAM-23).
bool limited(const io::AxisChannel& axis, bool synchronous);
bool withinLimits(const io::AxisChannel& axis, std::int64_t position);

}  // namespace merker::positioning
