#include "positioning/axis_values.h"

#include <algorithm>
#include <iterator>

#include "base/text.h"

namespace merker::positioning {
namespace {

// Beside the outputs of the blocks: what the channel puts out at its terminals.
constexpr AxisValue kValues[] = {
    {"position", "", false,
     [](const Channel&, const Image& i) { return std::int64_t{i.position}; }},
    {"distance_to_go", "", false,
     [](const Channel&, const Image& i) { return std::int64_t{i.distanceToGo}; }},
    {"target", "", false,
     [](const Channel&, const Image& i) { return std::int64_t{i.lastTarget}; }},
    {"mode", "", false,
     [](const Channel&, const Image& i) { return static_cast<std::int64_t>(i.mode); }},
    {"errors", "", false, [](const Channel&, const Image& i) { return std::int64_t{i.errors}; }},
    {"working", "", true, [](const Channel&, const Image& i) { return std::int64_t{i.working}; }},
    {"reached", "", true,
     [](const Channel&, const Image& i) { return std::int64_t{i.positionReached}; }},
    {"synchronised", "", true,
     [](const Channel&, const Image& i) { return std::int64_t{i.synchronous}; }},
    {"start_enabled", "", true,
     [](const Channel&, const Image& i) { return std::int64_t{i.startEnabled}; }},
    {"parameterised", "", true,
     [](const Channel&, const Image& i) { return std::int64_t{i.parametrised}; }},
    {"changed_over", "", true,
     [](const Channel&, const Image& i) { return std::int64_t{i.changedOver}; }},
    {"cut_off", "", true, [](const Channel&, const Image& i) { return std::int64_t{i.cutOff}; }},
    {"ramp_up", "", true, [](const Channel&, const Image& i) { return std::int64_t{i.rampUp}; }},
    {"ramp_down", "", true,
     [](const Channel&, const Image& i) { return std::int64_t{i.rampDown}; }},
    {"down", "", true, [](const Channel&, const Image& i) { return std::int64_t{i.down}; }},
    {"measured", "", true, [](const Channel&, const Image& i) { return std::int64_t{i.measured}; }},
    {"length", "", false, [](const Channel&, const Image& i) { return std::int64_t{i.length}; }},
    {"setpoint", "1/s", false,
     [](const Channel& c, const Image&) { return c.outputs().setPoint / kThousandths; }},
    {"enable", "", true,
     [](const Channel& c, const Image&) { return std::int64_t{c.outputs().enable}; }},
    {"direction", "", true,
     [](const Channel& c, const Image&) { return std::int64_t{c.outputs().direction}; }},
    {"contactors", "", false,
     [](const Channel& c, const Image&) { return std::int64_t{c.outputs().digital}; }},
};

}  // namespace

std::span<const AxisValue> axisValues() { return kValues; }

const AxisValue* findAxisValue(std::string_view name) {
  const auto* found = std::find_if(std::begin(kValues), std::end(kValues), [&](const AxisValue& v) {
    return equalsIgnoreCase(v.name, name);
  });
  return found == std::end(kValues) ? nullptr : found;
}

std::string axisValueNames() {
  std::string list;
  for (const AxisValue& value : kValues) {
    if (!list.empty()) list += ", ";
    list += value.name;
  }
  return list;
}

std::int64_t read(const AxisValue& value, const Channel& channel) {
  return value.read(channel, channel.image());
}

}  // namespace merker::positioning
