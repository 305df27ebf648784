#include "s7comm/messages.h"

#include "base/bytes.h"
#include "s7comm/data_item.h"
#include "s7comm/message_object.h"

namespace merker::s7comm {
namespace {

constexpr std::uint8_t kCpuFunctions = 4;
constexpr std::uint8_t kDiagnosticMessage = 0x03, kAcknowledged = 0x0C, kAlarmSq = 0x11,
                       kAlarmS = 0x12;

// Time, function, number of objects.
Bytes messageHead(const ClockTime& time) {
  Bytes data(time.begin(), time.end());
  data.insert(data.end(), {0, 1});
  return data;
}

// Behind the number: the signal, its state, acknowledged going and coming; one signal is bit 0.
void appendSignal(Bytes& data, const AlarmState& alarm) {
  data.insert(data.end(), {static_cast<std::uint8_t>(alarm.signal), 0, 1,
                           static_cast<std::uint8_t>(alarm.acknowledged)});
}

}  // namespace

void appendObject(Bytes& data, ObjectSyntax syntax, std::uint8_t values, std::uint32_t number) {
  const std::uint8_t length = syntax == ObjectSyntax::Indication ? 10 : 8;
  data.insert(data.end(), {kVariableObject, length, static_cast<std::uint8_t>(syntax), values});
  appendDWord(data, number);
}

Indication modeIndication(ModeCode mode) {
  return {.group = 0, .subfunction = static_cast<std::uint8_t>(mode)};
}

Indication diagnosticIndication(View entry) {
  return {.group = kCpuFunctions,
          .subfunction = kDiagnosticMessage,
          .octets = Bytes(entry.begin(), entry.end())};
}

Indication alarmIndication(const AlarmState& alarm) {
  const Bytes& value = alarm.signal ? alarm.comingValue : alarm.goingValue;
  Bytes data = messageHead(alarm.signal ? alarm.coming : alarm.going);
  appendObject(data, ObjectSyntax::Indication, value.empty() ? 0 : 1, alarm.number);
  appendSignal(data, alarm);
  if (!value.empty()) writeDataItem(data, {ItemCode::Done, DataUnit::Octets, value});
  return {.group = kCpuFunctions,
          .subfunction = alarm.waits ? kAlarmSq : kAlarmS,
          .octets = std::move(data)};
}

Indication acknowledgementIndication(const AlarmState& alarm, const ClockTime& time) {
  Bytes data = messageHead(time);
  appendObject(data, ObjectSyntax::Acknowledgement, 0, alarm.number);
  data.insert(data.end(), {1, static_cast<std::uint8_t>(alarm.acknowledged)});
  return {.group = kCpuFunctions, .subfunction = kAcknowledged, .octets = std::move(data)};
}

}  // namespace merker::s7comm
