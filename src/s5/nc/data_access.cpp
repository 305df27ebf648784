#include "nc/data_access.h"

namespace merker::nc::access {
namespace {

constexpr int kFirstByte = 5000, kFirstCentral = 900;
constexpr std::int32_t kHighestProgram = 9999;
enum ProgramType : std::int32_t { kMain = 1, kSub = 2 };

// A value of the unit of its data type: no places behind the point.
Value whole(std::int64_t value) { return makeNumber(value, 0); }
Value position(const Control& c, std::int64_t count) {
  return makeNumber(count, positionPlaces(c.inputSystem));
}
// Nothing beyond eight digits.
std::optional<Count> count(const Control& c, Number n) {
  const unsigned places = positionPlaces(c.inputSystem);
  const auto fits = makeNumber(scaled(n, places), places);
  return fits ? std::optional(fits->digits) : std::nullopt;
}

template <typename T>
bool assign(T& target, std::int64_t value) {
  target = static_cast<T>(value);
  return true;
}

bool assignCount(const Control& c, Count& target, Number n) {
  const auto value = count(c, n);
  return value && assign(target, *value);
}

unsigned index(int number, int first = 1) { return static_cast<unsigned>(number - first); }

ZeroOffset& settable(Control& c, const Where& w) {
  return c.settable.at(index(w[0])).at(index(w[1]));
}
Count& coarseOrFine(Control& c, const Where& w) {
  ZeroOffset& offset = settable(c, w);
  return w[2] == 0 ? offset.coarse : offset.fine;
}

// The program is selected and stands at its beginning.
bool select(Control& c, const Where& w, ProgramType type, Number n) {
  const std::int64_t program = scaled(n, 0);
  if (program < 1 || program > kHighestProgram) return false;
  auto& pointers = c.channels.at(index(w[0])).pointers;
  pointers = {};
  pointers[0].values = {type, static_cast<std::int32_t>(program), 0};
  return true;
}

}  // namespace

Value machineData(const Control& c, const Where& w, unsigned) {
  return whole(c.machineData.at(index(w[0], 0)));
}
bool setMachineData(Control& c, const Where& w, Number n) {
  return assign(c.machineData.at(index(w[0], 0)), n.digits);
}
Value machineDataByte(const Control& c, const Where& w, unsigned) {
  return whole(c.machineDataBytes.at(index(w[0], kFirstByte)));
}
bool setMachineDataByte(Control& c, const Where& w, Number n) {
  return assign(c.machineDataBytes.at(index(w[0], kFirstByte)), n.digits);
}
Value settingData(const Control& c, const Where& w, unsigned) {
  return whole(c.settingData.at(index(w[0], 0)));
}
bool setSettingData(Control& c, const Where& w, Number n) {
  return assign(c.settingData.at(index(w[0], 0)), n.digits);
}
Value settingDataByte(const Control& c, const Where& w, unsigned) {
  return whole(c.settingDataBytes.at(index(w[0], kFirstByte)));
}
bool setSettingDataByte(Control& c, const Where& w, Number n) {
  return assign(c.settingDataBytes.at(index(w[0], kFirstByte)), n.digits);
}

Value toolOffset(const Control& c, const Where& w, unsigned) {
  return c.tools.at(index(w[1])).at(index(w[2], 0));
}
bool setToolOffset(Control& c, const Where& w, Number n) {
  c.tools.at(index(w[1])).at(index(w[2], 0)) = n;
  return true;
}
bool addToToolOffset(Control& c, const Where& w, Number n) {
  Number& value = c.tools.at(index(w[0])).at(index(w[1], 0));
  const auto both = sum(value, n);
  if (both) value = *both;
  return both.has_value();
}

Value settableOffset(const Control& c, const Where& w, unsigned) {
  const ZeroOffset& offset = c.settable.at(index(w[0])).at(index(w[1]));
  return position(c, w[2] == 0 ? offset.coarse : offset.fine);
}
bool setSettableOffset(Control& c, const Where& w, Number n) {
  return assignCount(c, coarseOrFine(c, w), n);
}
bool addToSettableOffset(Control& c, const Where& w, Number n) {
  const auto both = sum(*settableOffset(c, w, 0), n);
  return both && assignCount(c, coarseOrFine(c, w), *both);
}
Value programmableOffset(const Control& c, const Where& w, unsigned) {
  return position(c, c.programmable.at(index(w[0])).at(index(w[1])));
}
bool setProgrammableOffset(Control& c, const Where& w, Number n) {
  return assignCount(c, c.programmable.at(index(w[0])).at(index(w[1])), n);
}
Value externalOffset(const Control& c, const Where& w, unsigned) {
  return position(c, c.external.at(index(w[0])));
}
bool setExternalOffset(Control& c, const Where& w, Number n) {
  return assignCount(c, c.external.at(index(w[0])), n);
}
Value preset(const Control& c, const Where& w, unsigned) {
  return position(c, c.preset.at(index(w[0])));
}
bool setPreset(Control& c, const Where& w, Number n) {
  return assignCount(c, c.preset.at(index(w[0])), n);
}
Value sumOffset(const Control& c, const Where& w, unsigned) {
  return position(c, c.sumOffset(index(w[0])));
}

Value workpiecePosition(const Control& c, const Where& w, unsigned) {
  return position(c, c.workpiecePosition(index(w[0])));
}
Value machinePosition(const Control& c, const Where& w, unsigned) {
  return position(c, c.axes.at(index(w[0])).position);
}
Value externalFeed(const Control& c, const Where& w, unsigned) {
  return c.channels.at(index(w[0])).externalFeed.at(index(w[1], 0));
}
bool setExternalFeed(Control& c, const Where& w, Number n) {
  if (n.digits < 0) return false;
  c.channels.at(index(w[0])).externalFeed.at(index(w[1], 0)) = n;
  return true;
}
Value programPointer(const Control& c, const Where& w, unsigned part) {
  return whole(c.channels.at(index(w[0])).pointers.at(index(w[1], 0)).values.at(part));
}
bool selectMainProgram(Control& c, const Where& w, Number n) { return select(c, w, kMain, n); }
bool selectSubprogram(Control& c, const Where& w, Number n) { return select(c, w, kSub, n); }
Value channelParameter(const Control& c, const Where& w, unsigned) {
  return c.parameters.at(index(w[0])).at(index(w[1], 0));
}
bool setChannelParameter(Control& c, const Where& w, Number n) {
  c.parameters.at(index(w[0])).at(index(w[1], 0)) = n;
  return true;
}
Value centralParameter(const Control& c, const Where& w, unsigned) {
  return c.centralParameters.at(index(w[1], kFirstCentral));
}
bool setCentralParameter(Control& c, const Where& w, Number n) {
  c.centralParameters.at(index(w[1], kFirstCentral)) = n;
  return true;
}
// 0 behind the last one.
Value alarm(const Control& c, const Where&, unsigned part) {
  return whole(part < c.alarms.size() ? c.alarms[part] : 0);
}

}  // namespace merker::nc::access
