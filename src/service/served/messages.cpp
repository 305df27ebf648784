#include "served/messages.h"

#include <algorithm>
#include <utility>

#include "cpu/cpu.h"
#include "s7comm/messages.h"
#include "station/block_cpu.h"
#include "system/alarms.h"
#include "system/szl.h"

namespace merker::served {
namespace {

using controller::Controller;
using controller::Mode;
using s7comm::AlarmState;
using s7comm::Error;
using s7comm::ItemCode;

constexpr std::size_t kEventOctets = 20;  // octets of the diagnostic buffer's entries

station::BlockCpu* messengerOf(Controller& plc) {
  return controller::capability<station::BlockCpu>(plc);
}

AlarmState alarmStateOf(const system::Alarm& alarm, const system::AlarmSignal& signal) {
  AlarmState state{.number = alarm.number,
                   .waits = alarm.waitsForAcknowledgement(),
                   .signal = signal.state,
                   .acknowledged = alarm.acknowledged};
  state.coming = cpu::toDateAndTime(alarm.coming.milliseconds);
  state.comingValue = alarm.coming.value.bytes;
  if (signal.state) return state;
  state.going = cpu::toDateAndTime(signal.milliseconds);
  state.goingValue = signal.value.bytes;
  return state;
}

s7comm::Indication messageOf(const system::AlarmMessage& message, const cpu::Cpu& cpu) {
  const AlarmState state = alarmStateOf(message.alarm, message.signal);
  if (!message.isAcknowledgement) return s7comm::alarmIndication(state);
  const auto now = cpu::toDateAndTime(cpu.clock().milliseconds(cpu.machine().clock));
  return s7comm::acknowledgementIndication(state, now);
}

// Event classes 8 to B are those of the program (SFC 52).
std::uint8_t eventKindOf(s7comm::View entry) {
  const unsigned eventClass = entry[0] >> 4;
  return eventClass >= 8 && eventClass <= 0xB ? s7comm::kUserEvents : s7comm::kSystemEvents;
}

s7comm::ModeCode modeCodeOf(Mode mode) {
  switch (mode) {
    case Mode::Startup:
      return s7comm::ModeCode::WarmRestart;
    case Mode::Run:
      return s7comm::ModeCode::Run;
    case Mode::Halt:
      return s7comm::ModeCode::Hold;
    default:
      return s7comm::ModeCode::Stop;
  }
}

// One code for each number.
template <typename Good>
std::vector<ItemCode> codesOf(const std::vector<std::uint32_t>& numbers, Good good) {
  std::vector<ItemCode> codes;
  for (const std::uint32_t number : numbers)
    codes.push_back(good(number) ? ItemCode::Done : ItemCode::Missing);
  return codes;
}

}  // namespace

void MessageLog::collect(Controller& plc) {
  auto* const cpu = messengerOf(plc);
  if (cpu == nullptr) return;
  for (const system::AlarmMessage& message : cpu->alarms().take())
    kept_.push_back(messageOf(message, cpu->cpu()));
  for (; kept_.size() > kMost; ++first_) kept_.pop_front();
}

std::vector<s7comm::Indication> MessageLog::since(std::uint64_t number) const {
  const auto skipped = std::min<std::uint64_t>(number > first_ ? number - first_ : 0, kept_.size());
  return {kept_.begin() + static_cast<std::ptrdiff_t>(skipped), kept_.end()};
}

MessageTask::MessageTask(std::shared_ptr<s7comm::Outlet> client, std::uint8_t kinds,
                         MessageLog& log, Controller& plc)
    : Task(std::move(client)), kinds_(kinds), log_(log), mode_(plc.mode()) {
  auto* const cpu = messengerOf(plc);
  events_ = cpu->cpu().diagnostics().added();
  if (wants(s7comm::kAlarms)) cpu->alarms().logOn();
  if (wants(s7comm::kUserEvents)) cpu->alarms().eventsWanted(true);
  log_.collect(plc);
  nextAlarm_ = log_.end();
}

void MessageTask::end(monitor::Monitor& monitor) {
  auto* const cpu = messengerOf(monitor.plc());
  if (cpu == nullptr) return;
  if (wants(s7comm::kAlarms)) cpu->alarms().logOff();
  if (wants(s7comm::kUserEvents)) cpu->alarms().eventsWanted(false);
}

bool MessageTask::run(monitor::Monitor& monitor) {
  sendMode(monitor.plc());
  sendEvents(monitor.plc());
  sendAlarms(monitor.plc());
  return true;
}

void MessageTask::sendMode(const Controller& plc) {
  const bool changed = std::exchange(mode_, plc.mode()) != mode_;
  if (changed && wants(s7comm::kModes)) client().send(s7comm::modeIndication(modeCodeOf(mode_)));
}

// The oldest of the new ones first; the list has the newest first.
void MessageTask::sendEvents(Controller& plc) {
  auto* const cpu = messengerOf(plc);
  const auto fresh =
      cpu->cpu().diagnostics().added() - std::exchange(events_, cpu->cpu().diagnostics().added());
  if (fresh == 0) return;
  const auto all = cpu->systemStatus(0x00A0, 0).data;
  auto left = std::min<std::size_t>(fresh, all.size() / kEventOctets);
  for (; left > 0; --left) {
    const s7comm::View entry = s7comm::View(all).subspan((left - 1) * kEventOctets, kEventOctets);
    if (wants(eventKindOf(entry))) client().send(s7comm::diagnosticIndication(entry));
  }
}

void MessageTask::sendAlarms(Controller& plc) {
  log_.collect(plc);
  const auto messages = log_.since(std::exchange(nextAlarm_, log_.end()));
  if (!wants(s7comm::kAlarms)) return;
  for (const s7comm::Indication& one : messages) client().send(one);
}

Error listen(Tasks& tasks, MessageLog& log, monitor::Monitor& monitor,
             const std::shared_ptr<s7comm::Outlet>& client, std::uint8_t kinds) {
  if (messengerOf(monitor.plc()) == nullptr) return Error::FunctionNotAvailable;
  const MessageTask* const old =
      tasks.find<MessageTask>(*client, [](const MessageTask&) { return true; });
  if (old != nullptr) tasks.remove(*old, monitor);
  if (kinds != 0) tasks.begin(std::make_shared<MessageTask>(client, kinds, log, monitor.plc()));
  return Error::None;
}

std::vector<ItemCode> acknowledgeAlarms(Controller& plc,
                                        const std::vector<std::uint32_t>& numbers) {
  auto* const cpu = messengerOf(plc);
  return codesOf(numbers, [&](std::uint32_t number) {
    return cpu != nullptr && cpu->alarms().acknowledge(number);
  });
}

std::vector<ItemCode> lockAlarms(Controller& plc, const std::vector<std::uint32_t>& numbers,
                                 bool locked) {
  auto* const cpu = messengerOf(plc);
  return codesOf(numbers, [&](std::uint32_t number) {
    return cpu != nullptr && cpu->alarms().lock(number, locked);
  });
}

std::optional<std::vector<AlarmState>> alarmsOf(Controller& plc) {
  auto* const cpu = messengerOf(plc);
  if (cpu == nullptr) return std::nullopt;
  std::vector<AlarmState> all;
  for (const auto& [number, alarm] : cpu->alarms().list())
    all.push_back(alarmStateOf(alarm, alarm.last));
  return all;
}

}  // namespace merker::served
