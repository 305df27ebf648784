#include "softplc/alarm_record.h"

#include <fmt/format.h>

#include <utility>

#include "base/bcd.h"

namespace merker::sinumerik {
namespace {

constexpr unsigned kAlarms = 6000;  // F000 shows numbers without it

// A STOP that the program or the programmer wanted.
bool isWish(Alarm alarm) {
  return alarm == Alarm::ProgrammerStop || alarm == Alarm::Stp || alarm == Alarm::Sts;
}

}  // namespace

AlarmRecord::AlarmRecord(const Machine& machine, const Surroundings& around)
    : machine_(machine), around_(around) {}

void AlarmRecord::note(std::string text) { alarms_.note(0, std::move(text), machine_.clock); }

void AlarmRecord::begin(Start kind) {
  alarms_.clear();
  note(kind == Start::Cold ? "Neustart (cold start)" : "Wiederanlauf (warm restart)");
  reason_.clear();
  byFault_ = false;
  kept_.reset();
  picture_ = {};
  controlBits_ = {};
  set(kind == Start::Cold ? ControlBit::NEUSTA : ControlBit::WIEDAN);
  if (kind == Start::Cold) fineCode_ = {};
}

void AlarmRecord::powerOff() {
  alarms_.clear();
  note("power off");
}

void AlarmRecord::code(const Trap& trap, bool stops) {
  const unsigned alarm = number(trap.alarm);
  fineCode_.code = stops ? static_cast<std::uint16_t>(alarm - kAlarms) : std::uint16_t{0};
  fineCode_.number = static_cast<std::uint16_t>(toBcd(alarm, 4));
  fineCode_.words = trap.words;
}

void AlarmRecord::message(const Trap& trap) {
  code(trap, false);
  alarms_.announce(number(trap.alarm), describe(trap.alarm), machine_.clock, false);
}

void AlarmRecord::stop(const Trap& trap, ControlBit also, bool startUp) {
  code(trap, true);
  picture_ = trap.alarm == Alarm::Stp && kept_ ? *kept_ : pictureNow();
  addCause(picture_, machine_, trap.alarm);
  if (also == ControlBit::NAUAS) picture_.interrupt.causes.set(Cause::NAU);
  set(row(trap.alarm).control);
  set(also);
  set(startUp ? ControlBit::MAFEHL : ControlBit::UAFEHL);
  const std::string text = describe(trap.alarm);
  alarms_.add(kPlcStop, "3 PLC-Stop", machine_.clock, true);
  alarms_.add(number(trap.alarm), text, machine_.clock, true);
  byFault_ = !isWish(trap.alarm);
  reason_ = text + place();
  alarms_.note(number(trap.alarm), "STOP: " + reason_, machine_.clock);
}

void AlarmRecord::stopWithout(std::string text) {
  picture_ = pictureNow();
  if (!around_.batteryGood) picture_.interrupt.causes.set(Cause::BAU);
  set(ControlBit::MAFEHL);
  alarms_.add(kPlcStop, "3 PLC-Stop", machine_.clock, true);
  alarms_.note(kPlcStop, "STOP: " + text, machine_.clock);
  reason_ = std::move(text);
  byFault_ = true;
}

void AlarmRecord::keepPicture() { kept_ = pictureNow(); }

StopPicture AlarmRecord::pictureNow() const {
  return takePicture(machine_, controlRegister(around_.batteryGood));
}

std::string AlarmRecord::place() const {
  if (!picture_.interrupt.block) return {};
  return fmt::format(", {} word {}", toString(*picture_.interrupt.block),
                     picture_.interrupt.relativeStep);
}

}  // namespace merker::sinumerik
