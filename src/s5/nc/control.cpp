#include "nc/control.h"

#include <algorithm>

namespace merker::nc {

void Control::raise(std::uint16_t alarm) {
  if (std::find(alarms.begin(), alarms.end(), alarm) == alarms.end()) alarms.push_back(alarm);
}

void Control::clear(std::uint16_t alarm) { std::erase(alarms, alarm); }

// Settable offset of the group in force in the axis's channel, G58, G59, external offset, PRESET.
std::int64_t Control::sumOffset(unsigned axis) const {
  const unsigned channel = axes.at(axis).channel - 1u;
  const ZeroOffset& group = settable.at(channels.at(channel).settableGroup - 1u).at(axis);
  std::int64_t sum = std::int64_t{group.coarse} + group.fine + external[axis] + preset[axis];
  for (const auto& offsets : programmable) sum += offsets[axis];
  return sum;
}

void forgetBuffered(Control& control) {
  Control empty;
  empty.inputSystem = control.inputSystem;
  empty.axes = control.axes;
  empty.spindleSpeed = control.spindleSpeed;
  empty.signals = control.signals;
  control = std::move(empty);
}

}  // namespace merker::nc
