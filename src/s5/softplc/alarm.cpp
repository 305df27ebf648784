#include "softplc/alarm.h"

#include <fmt/format.h>

#include <array>

namespace merker::sinumerik {
namespace {

constexpr AlarmRow kAlarmRows[] = {
#define ALARM(number, id, text, meaning, reaction, control, cause) \
  {Alarm::id, text, meaning, Reaction::reaction, ControlBit::control, Cause::cause},
#include "softplc/alarms.inc"
#undef ALARM
};

constexpr std::array<std::string_view, 12> kCauses = {
    "", "STOPS", "STUEB", "NAU", "QVZ", "ZYK", "BAU", "SUF", "STUEU", "ADF", "PARI", "TRAF"};

}  // namespace

std::string_view name(Cause cause) { return kCauses[static_cast<std::size_t>(cause)]; }

std::span<const AlarmRow> alarmRows() { return kAlarmRows; }

const AlarmRow& row(Alarm alarm) {
  for (const AlarmRow& r : kAlarmRows)
    if (r.alarm == alarm) return r;
  return kAlarmRows[0];
}

std::string describe(Alarm alarm) {
  const AlarmRow& r = row(alarm);
  return fmt::format("{} {} ({})", number(alarm), r.text, r.meaning);
}

}  // namespace merker::sinumerik
