// SFC 17 ALARM_SQ, 18 ALARM_S, 107 ALARM_DQ, 108 ALARM_D, 19 ALARM_SC: block-related messages
// (System Software for S7-300/400, volume 2, 24.13 to 24.15).
#include "system/call.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kNoValue = 0x0001;  // sent without its value: SD too long, or not there

bool isValueType(TypeCode type) {
  return (type >= TypeCode::Bool && type <= TypeCode::S5Time) || type == TypeCode::DateAndTime;
}

// False if the message goes without it.
template <typename A>
bool readValue(A& a, AlarmValue& value) {
  AnyPointer where = a.any("SD");
  const bool bit = where.type == TypeCode::Bool;
  const std::uint32_t bytes = byteCount(where);
  if (!isValueType(where.type) || bytes == 0 || bytes > AlarmValue::kMost) return false;
  if (bit && where.count != 1) return false;
  const std::uint32_t number = where.pointer % 8;
  if (bit) where.pointer -= number;
  const Region region = a.region(where, bytes, cpu::Access::Read);
  if (!region) return false;
  value.type = static_cast<std::uint8_t>(where.type);
  value.bytes.assign(region.data, region.data + bytes);
  if (bit) value.bytes[0] = value.bytes[0] >> number & 1;
  return true;
}

template <typename A>
void reportAlarm(A& a, std::uint32_t component) {
  AlarmSignal signal{.state = a.flag("SIG"),
                     .milliseconds = a.cpu().clock().milliseconds(a.machine().clock),
                     .value = {}};
  const bool whole = readValue(a, signal.value);
  const Alarms::Result result =
      a.alarms().report({a.value("EV_ID"), a.functionNumber(), component, std::move(signal)});
  a.status(result == Alarms::Result::Good && !whole ? kNoValue
                                                    : static_cast<std::uint32_t>(result));
}

}  // namespace

void alarmWithAcknowledgement(Sfc<17>& a) { reportAlarm(a, 0); }
void alarmAcknowledged(Sfc<18>& a) { reportAlarm(a, 0); }

template <typename A>
void componentAlarm(A& a) {
  const std::uint32_t component = a.value("CMP_ID");
  if (component == 0) return a.status(static_cast<std::uint32_t>(Alarms::Result::BadNumber));
  reportAlarm(a, component);
}
void componentAlarmWithAcknowledgement(Sfc<107>& a) { componentAlarm(a); }
void componentAlarmAcknowledged(Sfc<108>& a) { componentAlarm(a); }

void alarmState(Sfc<19>& a) {
  constexpr std::uint32_t kNothingKnown = 0x8082;
  const std::uint32_t number = a.value("EV_ID");
  if (number == 0) return a.status(static_cast<std::uint32_t>(Alarms::Result::BadNumber));
  const Alarm* alarm = a.alarms().find(number);
  if (alarm == nullptr) return a.status(kNothingKnown);
  a.set("STATE", alarm->last.state);
  a.set("Q_STATE", alarm->acknowledged);
  a.status(0);
}

}  // namespace merker::system
