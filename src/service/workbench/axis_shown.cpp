#include "workbench/axis_shown.h"

#include <utility>

#include "positioning/axis_values.h"
#include "positioning/motion.h"
#include "workbench/terminal_operand.h"

namespace merker::workbench {
namespace {

using io::AxisChannel;
using io::AxisOutput;

// Where each signal of an axis belongs (POS-WIRE-01, -02, -05 to -08).
struct AxisWire {
  const char* signal;
  const char* slot;
  io::Side side;
  std::uint32_t channel;
  bool (*used)(const AxisChannel&);
};

bool always(const AxisChannel&) { return true; }
bool byAnalog(const AxisChannel& axis) { return axis.output == AxisOutput::Analog; }
bool byDigital(const AxisChannel& axis) { return !byAnalog(axis); }
bool byDirection(const AxisChannel& axis) {
  return byAnalog(axis) && axis.analogControl == io::AnalogControl::WithDirection;
}

constexpr AxisWire kWires[] = {
    {"SETPOINT", "2.3", io::Side::AnalogOutput, 0, byAnalog},
    {"ENABLE", "2.2", io::Side::DigitalOutput, 6, byAnalog},
    {"DIRECTION", "2.2", io::Side::DigitalOutput, 7, byDirection},
    {"Q0", "2.2", io::Side::DigitalOutput, 8, byDigital},
    {"Q1", "2.2", io::Side::DigitalOutput, 9, byDigital},
    {"Q2", "2.2", io::Side::DigitalOutput, 10, byDigital},
    {"Q3", "2.2", io::Side::DigitalOutput, 11, byDigital},
    {"A", "2.2", io::Side::DigitalInput, 0, always},
    {"B", "2.2", io::Side::DigitalInput, 1, always},
    {"N", "2.2", io::Side::DigitalInput, 2, always},
    {"WORKPIECE", "2.2", io::Side::DigitalInput, 3, always},
    {"REFERENCE", "2.2", io::Side::DigitalInput, 4, always},
};

Json wiresOf(const Plc& plc, const AxisChannel& axis) {
  Json list = Json::array();
  for (const AxisWire& wire : kWires) {
    const auto terminal = plc.rack()->terminal(wire.slot, wire.side, wire.channel);
    if (!wire.used(axis) || !terminal) continue;
    list.push_back({{"signal", wire.signal},
                    {"operand", terminalOperand(plc.rack()->configuration(), *terminal,
                                                plc.build().project.symbols)
                                    .operand}});
  }
  return list;
}

bool isOfAxis(std::int32_t systemBlock) {
  constexpr std::int32_t kAnalog = 44, kDigital = 46;
  return systemBlock == kAnalog || systemBlock == kDigital;
}

void add(Json& list, const std::string& id, std::int32_t function) {
  constexpr std::size_t kMost = 256;
  if (list.size() < kMost) list.push_back({{"id", id}, {"function", function}});
}

// Multiple instances: "DB 30.Axis", also within that of another function block.
void addWithin(Json& list, const std::string& path, const std::vector<block::Variable>& variables) {
  for (const block::Variable& variable : variables) {
    const std::string name = path + "." + variable.name;
    const block::Type& type = *variable.type;
    if (type.code == TypeCode::SystemFunctionBlock && isOfAxis(type.length))
      add(list, name, type.length);
    else if (type.code == TypeCode::FunctionBlock)
      addWithin(list, name, type.members);
  }
}

// Instances of SFB 44 and SFB 46, as they are named in an operand.
Json instancesOf(const Plc& plc) {
  Json list = Json::array();
  if (plc.program() == nullptr) return list;
  for (const auto& [id, block] : *plc.program()) {
    if (id.kind != BlockKind::DB || block.instanceOf < 0) continue;
    if (!block.instanceOfSystemBlock)
      addWithin(list, toString(id), block.variables);
    else if (isOfAxis(block.instanceOf))
      add(list, toString(id), block.instanceOf);
  }
  return list;
}

const positioning::Channel* channelOf(const Plc& plc) {
  const auto* owner = controller::capability<positioning::AxisOwner>(plc.controller());
  return owner == nullptr ? nullptr : owner->axis();
}

}  // namespace

Json axisRow(const Plc& plc) {
  const positioning::Channel* channel = channelOf(plc);
  if (channel == nullptr || plc.rack() == nullptr) return nullptr;
  const AxisChannel& axis = *plc.rack()->configuration().axis();
  return {{"output", byAnalog(axis) ? "analog" : "digital"},
          {"directionSignal", byDirection(axis)},
          {"controlType", axis.digitalControl},
          {"rotary", axis.rotary},
          {"inverted", axis.inverted},
          {"rotaryEnd", axis.rotaryEnd},
          {"lowLimit", axis.lowLimit},
          {"highLimit", axis.highLimit},
          {"targetRange", 2 * positioning::halfRange(axis)},
          {"highestSpeed", axis.highestSpeed},
          {"creepSpeed", axis.creepSpeed},
          {"wires", wiresOf(plc, axis)},
          {"blocks", instancesOf(plc)}};
}

Json axisShown(const Plc& plc) {
  const positioning::Channel* channel = channelOf(plc);
  if (channel == nullptr) return nullptr;
  Json values = Json::object();
  for (const positioning::AxisValue& value : positioning::axisValues())
    values[std::string(value.name)] = positioning::read(value, *channel);
  return values;
}

}  // namespace merker::workbench
