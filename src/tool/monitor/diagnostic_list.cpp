#include "monitor/diagnostic_list.h"

#include <fmt/format.h>

#include "base/bytes.h"
#include "cpu/asynchronous_errors.h"
#include "cpu/cpu.h"

namespace merker::monitor {
namespace {

// Bytes 6 and 7 of the start information of OB 82, 83 and 122.
std::optional<DiagnosticLine::ModuleAddress> moduleOf(const cpu::DiagnosticEvent& event) {
  constexpr std::uint16_t kReadAccess = 0x2942, kWriteAccess = 0x2943;
  const bool access = event.event == kReadAccess || event.event == kWriteAccess;
  if (!access && !cpu::namesModule(event.event)) return {};
  return DiagnosticLine::ModuleAddress{loadWord(&event.info[4]), event.event == kWriteAccess};
}

}  // namespace

std::vector<DiagnosticLine> diagnosticList(const station::Station& station) {
  const cpu::Cpu& cpu = station.cpu();
  static const block::Program kNone;
  std::vector<DiagnosticLine> list;
  const auto& events = cpu.diagnostics().events();
  for (auto event = events.rbegin(); event != events.rend(); ++event) {
    DiagnosticLine line;
    line.number = static_cast<unsigned>(list.size()) + 1;
    line.time = event->time;
    line.clock = cpu::fromDateAndTime(event->stamp.data()).value_or(0);
    line.event = event->event;
    line.eventText = fmt::format("16#{:04X}", event->event);
    line.text = event->text;
    line.help = diagnosticHelp(event->event);
    if (event->place.known)
      line.place = sourcePlace(event->place.replaced ? kNone : station.program(),
                               event->place.block, event->place.offset);
    line.module = moduleOf(*event);
    list.push_back(std::move(line));
  }
  return list;
}

}  // namespace merker::monitor
