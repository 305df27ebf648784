// Where a run of each mode goes (POS-JOG-10, POS-REF, POS-INCR, POS-INCA), and what is wrong with
// it: the error classes 34h and 35h.
#pragma once

#include "positioning/start.h"

namespace merker::positioning {

Decision jog(const io::AxisChannel& axis, const Situation& now, const Request& request);
Decision reference(const io::AxisChannel& axis, const Situation& now, const Request& request);
Decision relative(const io::AxisChannel& axis, const Situation& now, const Request& request);
Decision absolute(const io::AxisChannel& axis, const Situation& now, const Request& request);
// Of an interrupted run: to its target, or back to where it started.
Decision continued(const io::AxisChannel& axis, const Situation& now, const Request& request);

}  // namespace merker::positioning
