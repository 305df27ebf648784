#include "cpu/event_log.h"

#include <algorithm>

#include "base/bytes.h"
#include "cpu/levels.h"

namespace merker::cpu {

DateAndTime EventLog::dateAndTime() const {
  return toDateAndTime(clock_.milliseconds(machine_.clock));
}

Place EventLog::here() const {
  if (machine_.levels.empty() || machine_.top->code == nullptr) return {};
  return {.known = true, .block = machine_.top->code->source->id, .offset = machine_.position};
}

DiagnosticEvent EventLog::entry(std::uint16_t event, std::string text, Place place) const {
  DiagnosticEvent result{.event = event,
                         .time = machine_.clock,
                         .text = std::move(text),
                         .place = place,
                         .stamp = dateAndTime()};
  const DiagnosticInformation info = informationOf(place);
  result.info[0] = runningPriority(machine_);
  result.info[1] = runningOb(machine_);
  std::copy(info.begin(), info.end(), result.info.begin() + 2);
  return result;
}

void EventLog::report(Event event, Place place) {
  add(entry(static_cast<std::uint16_t>(event), std::string(text(event)), place));
}

void EventLog::report(Event event, std::string text) {
  add(entry(static_cast<std::uint16_t>(event), std::move(text), {}));
}

void EventLog::report(const StartInformation& start, std::string text) {
  DiagnosticEvent result = entry(loadWord(start.data()), std::move(text), here());
  std::copy_n(start.begin() + 2, result.info.size(), result.info.begin());
  add(std::move(result));
}

void EventLog::note(std::uint16_t event, std::string text, const DiagnosticInformation& info) {
  DiagnosticEvent result = entry(event, std::move(text), {});
  std::copy(info.begin(), info.end(), result.info.begin() + 2);
  add(std::move(result));
}

}  // namespace merker::cpu
