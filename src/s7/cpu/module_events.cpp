#include "cpu/module_events.h"

#include <algorithm>

#include "base/bytes.h"
#include "cpu/asynchronous_errors.h"
#include "cpu/levels.h"

namespace merker::cpu {
namespace {

using Kind = ModuleEvent::Kind;

// Start information of what is no hardware interrupt. `came`: the kind that this one ends.
struct Row {
  Kind kind;
  std::uint8_t ob, eventClass, faultId;
  Kind came;
};
constexpr Row kRows[] = {
    {Kind::DiagnosticComing, 82, 0x39, 0x42, Kind::DiagnosticComing},
    {Kind::DiagnosticGoing, 82, 0x38, 0x42, Kind::DiagnosticComing},
    {Kind::Removed, 83, 0x39, 0x61, Kind::Removed},
    {Kind::Inserted, 83, 0x38, 0x61, Kind::Removed},
    {Kind::RackFailed, 86, 0x39, 0xC1, Kind::RackFailed},
    {Kind::RackReturned, 86, 0x38, 0xC1, Kind::RackFailed},
    {Kind::StationFailed, 86, 0x39, 0xC4, Kind::StationFailed},
    {Kind::StationReturned, 86, 0x38, 0xC4, Kind::StationFailed},
};

const Row& rowOf(Kind kind) {
  return *std::find_if(std::begin(kRows), std::end(kRows),
                       [&](const Row& row) { return row.kind == kind; });
}

// IO_FLAG, MDL_ID
std::uint8_t direction(const ModuleEvent& event) { return event.output ? 0x55 : 0x54; }

bool sameModule(const StartInformation& start, const ModuleEvent& event) {
  return start[3] == 40 && start[5] == direction(event) && loadWord(&start[6]) == event.address;
}

}  // namespace

void ModuleEvents::happened(const ModuleEvent& event) {
  if (event.kind == Kind::HardwareInterrupt) return hardwareInterrupt(event);
  const Row& row = rowOf(event.kind);
  const PresentFaults::Module module{row.came, event.address, event.output,
                                     row.ob == 86 ? event.points : 0};
  row.eventClass == 0x39 ? parts_.faults.come(module) : parts_.faults.go(module);
  StartInformation start = startInformation(row.eventClass, row.faultId, priorityOf(row.ob), row.ob,
                                            parts_.log.dateAndTime());
  if (row.ob != 86) setByte(start, 5, direction(event));
  setWord(start, 6, event.address);
  if (row.ob == 82) std::copy(event.data.begin(), event.data.end(), start.begin() + 8);
  if (row.ob == 86) setDWord(start, 8, event.points);  // RACKS_FLTD: bit n is rack n
  // A CPU without this OB cannot be told what to do: an entry. Its program meets access errors.
  const bool plugging = row.ob == 83 || row.ob == 86;
  if (plugging && !machine_.model->hasOrganizationBlock(row.ob))
    return parts_.log.report(start, describe(start));
  parts_.requests.asynchronousError(start);
}

bool ModuleEvents::busy(const ModuleEvent& event) const {
  const auto same = [&](const auto& one) { return sameModule(one.start, event); };
  const auto& waiting = parts_.requests.waiting();
  return std::any_of(waiting.begin(), waiting.end(), same) ||
         std::any_of(machine_.levels.begin(), machine_.levels.end(), same);
}

// A module waits until OB 40 has ended; what its channels report until then it stores, one edge
// each (S7-ERR-05).
void ModuleEvents::hardwareInterrupt(const ModuleEvent& event) {
  constexpr std::uint8_t kOb = 40;
  if (parts_.state.mode() == Mode::Stop || interrupts_.isLocked(kOb))
    return parts_.modules.acknowledge(event.address);
  StartInformation start =
      startInformation(0x11, 0x41, priorityOf(kOb), kOb, parts_.log.dateAndTime());
  setByte(start, 5, direction(event));
  setWord(start, 6, event.address);
  setDWord(start, 8, event.points);
  if (!hasOb(machine_, kOb)) return parts_.requests.obMissing(start);
  if (!busy(event)) return parts_.requests.queue(start);
  store(event, start);
}

// Lost for good is what is stored already: an entry, and OB 80 if it is loaded.
void ModuleEvents::store(const ModuleEvent& event, const StartInformation& start) {
  const auto at = std::find_if(stored_.begin(), stored_.end(), [&](const ModuleEvent& other) {
    return other.address == event.address && other.output == event.output;
  });
  if (at == stored_.end()) return stored_.push_back(event);
  const std::uint32_t lost = at->points & event.points;
  at->points |= event.points;
  if (lost == 0) return;
  if (hasOb(machine_, 80)) return parts_.requests.timeError(0x02, event.address, start);
  parts_.log.report(Event::RequestError, "hardware interrupt lost");
  parts_.faults.program = true;
}

void ModuleEvents::hardwareInterruptEnded(const StartInformation& ended) {
  parts_.modules.acknowledge(loadWord(&ended[6]));
  const auto at = std::find_if(stored_.begin(), stored_.end(),
                               [&](const ModuleEvent& event) { return sameModule(ended, event); });
  if (at == stored_.end()) return;
  const ModuleEvent event = *at;
  stored_.erase(at);
  hardwareInterrupt(event);
}

// S7-OBI-08: byte 6 rack 0.
void ModuleEvents::setBattery(bool low) {
  if (parts_.faults.battery == low) return;
  parts_.faults.battery = low;
  parts_.requests.asynchronousError(
      startInformation(low ? 0x39 : 0x38, 0x22, priorityOf(81), 81, parts_.log.dateAndTime()));
}

}  // namespace merker::cpu
