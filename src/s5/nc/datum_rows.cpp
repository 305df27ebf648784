// The table of the NC's data by name.
#include "nc/data_access.h"
#include "nc/datum.h"

namespace merker::nc {
namespace {

using namespace access;
using sinumerik::NcSide;

constexpr Limit kAxis{1, kAxes}, kChannel{1, kChannels}, kSpindle{1, kSpindles}, kPair{1, 2};
constexpr Limit kFlag{0, 1}, kWords{0, 4999}, kBytes{5000, 9999}, kTool{1, kTools};
constexpr Limit kValue{0, kToolValues - 1}, kGroup{1, kSettableGroups},
    kG58{1, kProgrammableGroups};
constexpr Limit kLevel{0, kLevels - 1}, kPart{1, 3}, kAlarm{1, 9999}, kList{1, 127};
constexpr auto kWhole = Content::Whole;
constexpr auto kFloating = Content::Floating;
constexpr auto kPosition = Content::Position;
constexpr std::int32_t kSigned = -1;  // of a number with a point: both signs
constexpr std::int32_t kHighestProgram = 9999;

std::size_t at(int number) { return static_cast<std::size_t>(number - 1); }
Value whole(std::int64_t value) { return Number{static_cast<std::int32_t>(value), 0}; }

// [which] and [type] of an array of feeds.
template <std::size_t type>
Value feed(const Control& c, const Where& w, unsigned) {
  return c.axes.at(at(w[0])).feed.at(type);
}
template <std::size_t type>
bool setFeed(Control& c, const Where& w, Number n) {
  c.axes.at(at(w[0])).feed.at(type) = n;
  return true;
}
template <std::size_t type>
Value pathFeed(const Control& c, const Where& w, unsigned) {
  return c.channels.at(at(w[0])).pathFeed.at(type);
}
template <std::size_t type>
bool setPathFeed(Control& c, const Where& w, Number n) {
  c.channels.at(at(w[0])).pathFeed.at(type) = n;
  return true;
}

// A member of an axis or channel that is a whole number.
template <auto member>
Value ofAxis(const Control& c, const Where& w, unsigned) {
  return whole(c.axes.at(at(w[0])).*member);
}
template <auto member>
bool setOfAxis(Control& c, const Where& w, Number n) {
  auto& value = c.axes.at(at(w[0])).*member;
  value = static_cast<std::remove_reference_t<decltype(value)>>(n.digits);
  return true;
}
template <auto member>
Value ofSignals(const Control& c, const Where&, unsigned) {
  return whole(c.signals.*member);
}
template <auto member>
bool setOfSignals(Control& c, const Where&, Number n) {
  auto& value = c.signals.*member;
  value = static_cast<std::remove_reference_t<decltype(value)>>(n.digits);
  return true;
}
// One of two: probe 1 and 2, blocks of the first and second program.
template <auto first, auto second>
Value ofPair(const Control& c, const Where& w, unsigned part) {
  return w[0] == 1 ? ofSignals<first>(c, w, part) : ofSignals<second>(c, w, part);
}
template <auto first, auto second>
bool setOfPair(Control& c, const Where& w, Number n) {
  return w[0] == 1 ? setOfSignals<first>(c, w, n) : setOfSignals<second>(c, w, n);
}

Value group(const Control& c, const Where& w, unsigned) {
  return whole(c.channels.at(at(w[0])).settableGroup);
}
bool setGroup(Control& c, const Where& w, Number n) {
  c.channels.at(at(w[0])).settableGroup = static_cast<std::uint8_t>(n.digits);
  return true;
}
bool setPosition(Control& c, const Where& w, Number n) {
  c.axes.at(at(w[0])).position = static_cast<Count>(scaled(n, positionPlaces(c.inputSystem)));
  return true;
}
Value speed(const Control& c, const Where& w, unsigned) {
  return whole(c.spindleSpeed.at(at(w[0])));
}
bool setSpeed(Control& c, const Where& w, Number n) {
  c.spindleSpeed.at(at(w[0])) = n.digits;
  return true;
}
// Level 0 begins with the type of the program: none, main program, subprogram.
bool setPointer(Control& c, const Where& w, Number n) {
  if (w[1] == 0 && w[2] == 1 && n.digits > 2) return false;
  c.channels.at(at(w[0])).pointers.at(static_cast<std::size_t>(w[1])).values.at(at(w[2])) =
      n.digits;
  return true;
}
Value pending(const Control& c, const Where& w, unsigned) {
  for (const std::uint16_t alarm : c.alarms)
    if (alarm == w[0]) return whole(1);
  return whole(0);
}
bool setPending(Control& c, const Where& w, Number n) {
  const auto alarm = static_cast<std::uint16_t>(w[0]);
  n.digits != 0 ? c.raise(alarm) : c.clear(alarm);
  return true;
}
Value inList(const Control& c, const Where& w, unsigned) {
  return at(w[0]) < c.alarms.size() ? whole(c.alarms[at(w[0])]) : whole(0);
}
Value stop(const Control& c, const Where&, unsigned) { return whole(c.machiningStop ? 1 : 0); }
bool setStop(Control& c, const Where&, Number n) {
  c.machiningStop = n.digits != 0;
  return true;
}
Value system(const Control& c, const Where&, unsigned) {
  return whole(static_cast<std::int64_t>(c.inputSystem));
}
bool setSystem(Control& c, const Where&, Number n) {
  c.inputSystem = n.digits != 0 ? InputSystem::Inch : InputSystem::Metric;
  return true;
}

constexpr std::string_view kLength = "mm, inch or degrees",
                           kSpeed = "mm/min, inch/min or degrees/min";
constexpr std::string_view kPerTurn = "mm or inch per revolution", kTurns = "1/min";

// name, alias, what its numbers mean, their limits, those that may be left out, content, limits of
// a whole number, unit, get, put, in merker.toml
// clang-format off
constexpr std::array kRows{
    DatumRow{"R", "parameters", "channel.number, channel 1 if left out", {Limit{1, 2}, Limit{0, kChannelParameters - 1}}, 1, {}, kFloating, kSigned, 0, "", channelParameter, setChannelParameter},
    DatumRow{"R", "parameters", "0.number, central", {Limit{0, 0}, Limit{900, 999}}, 0, {}, kFloating, kSigned, 0, "", centralParameter, setCentralParameter},
    DatumRow{"tool", "", "D.P", {kTool, kValue}, {}, {}, kFloating, kSigned, 0, "as its P number", [](const Control& c, const Where& w, unsigned p) { return toolOffset(c, {0, w[0], w[1]}, p); }, [](Control& c, const Where& w, Number n) { return setToolOffset(c, {0, w[0], w[1]}, n); }},
    DatumRow{"machine_data", "MD", "number", {kWords}, {}, {}, kWhole, INT32_MIN, INT32_MAX, "as the datum", machineData, setMachineData},
    DatumRow{"machine_data", "MD", "number of a byte", {kBytes}, {}, {}, kWhole, 0, 255, "bits", machineDataByte, setMachineDataByte},
    DatumRow{"setting_data", "SD", "number", {kWords}, {}, {}, kWhole, INT32_MIN, INT32_MAX, "as the datum", settingData, setSettingData},
    DatumRow{"setting_data", "SD", "number of a byte", {kBytes}, {}, {}, kWhole, 0, 255, "bits", settingDataByte, setSettingDataByte},
    DatumRow{"position", "", "axis", {kAxis}, {}, {}, kPosition, kSigned, 0, kLength, machinePosition, setPosition},
    DatumRow{"workpiece_position", "", "axis", {kAxis}, {}, {}, kPosition, kSigned, 0, kLength, access::workpiecePosition, nullptr, false},
    DatumRow{"settable_offset", "", "group.axis.fine, fine 0 if left out", {kGroup, kAxis, kFlag}, {}, 0, kPosition, kSigned, 0, kLength, settableOffset, setSettableOffset},
    DatumRow{"settable_group", "", "channel", {kChannel}, {}, {}, kWhole, 1, kSettableGroups, "1 to 4: G54 to G57", group, setGroup},
    DatumRow{"programmable_offset", "", "group.axis", {kG58, kAxis}, {}, {}, kPosition, kSigned, 0, kLength, programmableOffset, setProgrammableOffset},
    DatumRow{"external_offset", "", "axis", {kAxis}, {}, {}, kPosition, kSigned, 0, kLength, externalOffset, setExternalOffset},
    DatumRow{"preset", "", "axis", {kAxis}, {}, {}, kPosition, kSigned, 0, kLength, access::preset, setPreset},
    DatumRow{"sum_offset", "", "axis", {kAxis}, {}, {}, kPosition, kSigned, 0, kLength, access::sumOffset, nullptr, false},
    DatumRow{"feed", "feed_g94", "axis", {kAxis}, {}, {}, kFloating, 0, 0, kSpeed, feed<0>, setFeed<0>},
    DatumRow{"feed_g95", "", "axis", {kAxis}, {}, {}, kFloating, 0, 0, kPerTurn, feed<1>, setFeed<1>},
    DatumRow{"feed_g98", "", "axis", {kAxis}, {}, {}, kFloating, 0, 0, kTurns, feed<2>, setFeed<2>},
    DatumRow{"path_feed", "path_feed_g94", "channel", {kChannel}, {}, {}, kFloating, 0, 0, kSpeed, pathFeed<0>, setPathFeed<0>},
    DatumRow{"path_feed_g95", "", "channel", {kChannel}, {}, {}, kFloating, 0, 0, kPerTurn, pathFeed<1>, setPathFeed<1>},
    DatumRow{"path_feed_g98", "", "channel", {kChannel}, {}, {}, kFloating, 0, 0, kTurns, pathFeed<2>, setPathFeed<2>},
    DatumRow{"external_feed", "", "channel.type, linear (0) if left out", {kChannel, kFlag}, {}, 0, kFloating, 0, 0, "mm/min or inch/min; type 1 per revolution", externalFeed, setExternalFeed},
    DatumRow{"axis_channel", "", "axis", {kAxis}, {}, {}, kWhole, 1, kChannels, "channel in which it is programmed", ofAxis<&Axis::channel>, setOfAxis<&Axis::channel>},
    DatumRow{"following_error", "", "axis", {kAxis}, {}, {}, kWhole, INT32_MIN, INT32_MAX, "units of the position control", ofAxis<&Axis::followingError>, setOfAxis<&Axis::followingError>},
    DatumRow{"spindle_speed", "", "spindle", {kSpindle}, {}, {}, kWhole, INT32_MIN, INT32_MAX, kTurns, speed, setSpeed},
    DatumRow{"program_pointer", "", "channel.level.value", {kChannel, kLevel, kPart}, {}, {}, kWhole, 0, kHighestProgram, "level 0: type, program, block; else subprogram, passes, block", [](const Control& c, const Where& w, unsigned part) { return programPointer(c, w, part); }, setPointer},
    DatumRow{"alarm", "", "number of an NC alarm", {kAlarm}, {}, {}, kWhole, 0, 1, "1: it is pending", pending, setPending},
    DatumRow{"alarm_list", "", "place in the list", {kList}, {}, {}, kWhole, 0, 0, "number of the alarm, 0 behind the last", inList, nullptr, false},
    DatumRow{"machining_stop", "", "", {}, {}, {}, kWhole, 0, 1, "1: a pending alarm stops machining (M 24.3)", stop, setStop, false},
    DatumRow{"input_system", "", "", {}, {}, {}, kWhole, 0, 1, "0 metric, 1 inch", system, setSystem, false},
    DatumRow{"probe", "", "1 or 2", {kPair}, {}, {}, kWhole, 0, 1, "M 24.6, M 24.7", ofPair<&NcSide::probe1, &NcSide::probe2>, setOfPair<&NcSide::probe1, &NcSide::probe2>},
    DatumRow{"reloading", "", "", {}, {}, {}, kWhole, 0, 255, "MB 17", ofSignals<&NcSide::reloading>, setOfSignals<&NcSide::reloading>},
    DatumRow{"blocks", "", "program 1 or 2", {kPair}, {}, {}, kWhole, 0, 65535, "MB 19 and 20, MB 21 and 22", ofPair<&NcSide::blocks1, &NcSide::blocks2>, setOfPair<&NcSide::blocks1, &NcSide::blocks2>},
    DatumRow{"ring_full", "", "", {}, {}, {}, kWhole, 0, 1, "M 23.7", ofSignals<&NcSide::ringFull>, setOfSignals<&NcSide::ringFull>},
    DatumRow{"ring_empty", "", "", {}, {}, {}, kWhole, 0, 1, "M 23.6", ofSignals<&NcSide::ringEmpty>, setOfSignals<&NcSide::ringEmpty>},
    DatumRow{"serial", "", "", {}, {}, {}, kWhole, 0, 1, "M 23.0", ofSignals<&NcSide::serialRuns>, setOfSignals<&NcSide::serialRuns>}};
// clang-format on

}  // namespace

std::span<const DatumRow> datumRows() { return kRows; }

}  // namespace merker::nc
