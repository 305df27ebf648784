#include "nc/control.h"

#include <algorithm>

namespace merker::nc {

void Control::raise(std::uint16_t alarm) {
  if (std::find(alarms.begin(), alarms.end(), alarm) == alarms.end()) alarms.push_back(alarm);
}

// Settable offset of the group in force in the axis's channel, G58, G59, external offset, PRESET.
std::int64_t Control::sumOffset(unsigned axis) const {
  const unsigned channel = axes.at(axis).channel - 1u;
  const ZeroOffset& group = settable.at(channels.at(channel).settableGroup - 1u).at(axis);
  std::int64_t sum = std::int64_t{group.coarse} + group.fine + external[axis] + preset[axis];
  for (const auto& offsets : programmable) sum += offsets[axis];
  return sum;
}

}  // namespace merker::nc
