// Messages of a CPU (group 4): who wants which (02), lock and unlock (07, 08), acknowledge (0B),
// and those that stand (13h).
#include <algorithm>

#include "base/bytes.h"
#include "s7comm/data_item.h"
#include "s7comm/message_object.h"
#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

constexpr std::size_t kSubscription = 10;  // kinds, 0, name of the client; of alarms two more
constexpr std::uint8_t kLock = 0x07;
constexpr std::uint8_t kInitiate = 1;  // in the type: they begin, else they end

// Function, number of objects, and of each the number of its message. Nothing: no such octets.
std::optional<std::vector<std::uint32_t>> messageNumbers(View data, ObjectSyntax syntax) {
  constexpr std::size_t kHead = 2, kNumberEnd = 8;
  if (data.size() < kHead || data[1] == 0) return std::nullopt;
  std::vector<std::uint32_t> numbers(data[1]);
  data = data.subspan(kHead);
  for (std::uint32_t& number : numbers) {
    if (data.size() < kNumberEnd || data[0] != kVariableObject) return std::nullopt;
    const std::size_t length = 2u + data[1];
    if (length < kNumberEnd || data.size() < length) return std::nullopt;
    if (data[2] != static_cast<std::uint8_t>(syntax)) return std::nullopt;
    number = loadDWord(&data[4]);
    data = data.subspan(length);
  }
  return numbers;
}

// Function, number of objects, a code for each.
Messages::CodesDone answerCodes(const Request& request) {
  return [begun = request.begun(), function = request.data[0]](const std::vector<ItemCode>& codes) {
    Bytes data = {function, static_cast<std::uint8_t>(codes.size())};
    for (const ItemCode code : codes) data.push_back(static_cast<std::uint8_t>(code));
    begun.answer(std::move(data));
    begun.ended();
  };
}

// A value has a data item even where there is none.
void appendStand(Bytes& data, const ClockTime& time, const Bytes& value) {
  data.insert(data.end(), time.begin(), time.end());
  Bytes item;
  writeDataItem(item, {value.empty() ? ItemCode::Missing : ItemCode::Done,
                       value.empty() ? DataUnit::None : DataUnit::Octets, value});
  data.insert(data.end(), item.begin(), item.end());
}

// Octets behind the first one, 0, kind, number, 0, signal, acknowledged going and coming, both
// transitions.
Bytes alarmRecord(const AlarmState& alarm) {
  constexpr std::uint8_t kAlarmS = 4;
  Bytes data = {0, 0, 0, kAlarmS};
  appendDWord(data, alarm.number);
  data.insert(data.end(), {0, static_cast<std::uint8_t>(alarm.signal), 1,
                           static_cast<std::uint8_t>(alarm.acknowledged)});
  appendStand(data, alarm.coming, alarm.comingValue);
  appendStand(data, alarm.going, alarm.goingValue);
  data[0] = static_cast<std::uint8_t>(data.size() - 1);
  return data;
}

// One message a PDU, as an S7-300 does it: the first one behind a head without a length, and behind
// the last one an end.
void answerAlarms(const Request& request, const std::vector<AlarmState>& alarms) {
  if (alarms.empty())
    return request.answer({0, 1, static_cast<std::uint8_t>(ItemCode::Missing), 0, 0, 0});
  std::vector<Bytes> parts;
  for (const AlarmState& alarm : alarms) parts.push_back(alarmRecord(alarm));
  const Bytes head = {0,
                      1,
                      static_cast<std::uint8_t>(ItemCode::Done),
                      static_cast<std::uint8_t>(DataUnit::Octets),
                      0xFF,
                      0xFF};
  parts.front().insert(parts.front().begin(), head.begin(), head.end());
  parts.push_back({0, 0});
  request.answerParts(parts);
}

}  // namespace

void serveMessageService(const Request& request) {
  const View data = request.data;
  if (data.size() < kSubscription) return request.refuse(Error::WrongFunctionParameters);
  const bool alarms = (data[0] & kAlarms) != 0 && data.size() > kSubscription;
  Bytes answer = {0, 0};
  std::uint8_t kinds = data[0];
  if (alarms) {
    answer.insert(answer.end(), {data[kSubscription], 0, 0});
    if ((data[kSubscription] & kInitiate) == 0) kinds &= static_cast<std::uint8_t>(~kAlarms);
  }
  request.job.plc().listen(request.job.outlet(), kinds,
                           [begun = request.begun(), answer](Error error) {
                             error == Error::None ? begun.answer(answer) : begun.refuse(error);
                             begun.ended();
                           });
}

void serveAcknowledgeAlarms(const Request& request) {
  auto numbers = messageNumbers(request.data, ObjectSyntax::Acknowledgement);
  if (!numbers) return request.refuse(Error::WrongFunctionParameters);
  request.job.plc().acknowledge(std::move(*numbers), answerCodes(request));
}

void serveLockAlarms(const Request& request) {
  auto numbers = messageNumbers(request.data, ObjectSyntax::Lock);
  if (!numbers) return request.refuse(Error::WrongFunctionParameters);
  request.job.plc().lock(std::move(*numbers), request.subfunction == kLock, answerCodes(request));
}

// By kind (ALARM_S alone exists) or by number.
void serveAlarmQuery(const Request& request) {
  constexpr std::uint8_t kByNumber = 3, kAlarmS = 4;
  const View data = request.data;
  if (data.size() < 12 || data[4] != static_cast<std::uint8_t>(ObjectSyntax::Query))
    return request.refuse(Error::WrongFunctionParameters);
  const bool byNumber = data[6] == kByNumber;
  const std::uint32_t wanted = loadDWord(&data[8]);
  request.job.plc().alarms([begun = request.begun(), byNumber,
                            wanted](const std::optional<std::vector<AlarmState>>& all) {
    std::vector<AlarmState> found = all.value_or(std::vector<AlarmState>());
    std::erase_if(found, [&](const AlarmState& alarm) {
      return byNumber ? alarm.number != wanted : wanted != kAlarmS;
    });
    all ? answerAlarms(begun, found) : begun.refuse(Error::FunctionNotAvailable);
    begun.ended();
  });
}

}  // namespace merker::s7comm
