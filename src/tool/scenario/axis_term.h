// A value of the positioning axis, and what it should be: axis.position = 1000
// (docs/formats/scenario.md).
#pragma once

#include <string>
#include <string_view>

#include "check/check.h"
#include "io/configuration.h"
#include "positioning/axis_values.h"
#include "scenario/line.h"

namespace merker::simulator {

struct AxisTerm {
  std::string text;  // as written: "axis.position"
  Position position;
  const positioning::AxisValue* what = nullptr;
  std::string value;
  Position valuePosition;
  std::int64_t number = 0;  // after resolving
};

// Whether a text is meant for the axis: it begins with "axis.".
bool namesAxis(std::string_view text);
// Only to be looked at without a value.
bool parseAxis(std::string_view name, std::string_view value, AxisTerm& result,
               const PositionOf& at, Problems& problems);
// Whether there is an axis, and the value is one of it.
void resolve(AxisTerm& term, const io::Configuration* hardware, Problems& problems);

// Of a PLC whose hardware has one.
const positioning::Channel& axisOf(const controller::Controller& plc);
bool holds(const AxisTerm& term, block::Relation relation, const positioning::Channel& axis);
std::string actualValue(const AxisTerm& term, const positioning::Channel& axis);

}  // namespace merker::simulator
