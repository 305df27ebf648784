// What modules and the power supply tell the CPU: OB 40, 81, 82, 83, 86 (S7-BLK-11, S7-OBI-06, -08,
// -09, -11; S7-ERR-05).
#include <algorithm>

#include "base/bytes.h"
#include "cpu/asynchronous_errors.h"
#include "cpu/cpu.h"

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

void Cpu::moduleEvent(const ModuleEvent& event) {
  if (event.kind == Kind::HardwareInterrupt) return hardwareInterrupt(event);
  const Row& row = rowOf(event.kind);
  const PresentFaults::Module module{row.came, event.address, event.output,
                                     row.ob == 86 ? event.points : 0};
  row.eventClass == 0x39 ? faults_.come(module) : faults_.go(module);
  StartInformation start =
      startInformation(row.eventClass, row.faultId, priorityOf(row.ob), row.ob, dateAndTime());
  if (row.ob != 86) setByte(start, 5, direction(event));
  setWord(start, 6, event.address);
  if (row.ob == 82) std::copy(event.data.begin(), event.data.end(), start.begin() + 8);
  if (row.ob == 86) setDWord(start, 8, event.points);  // RACKS_FLTD: bit n is rack n
  // A CPU without this OB cannot be told what to do: an entry. Its program meets access errors.
  const bool plugging = row.ob == 83 || row.ob == 86;
  if (plugging && !machine_.model->hasOrganizationBlock(row.ob))
    return report(start, describe(start));
  asynchronousError(start);
}

// A module waits until OB 40 has ended; what its channels report until then it stores, one edge
// each (S7-ERR-05).
void Cpu::hardwareInterrupt(const ModuleEvent& event) {
  constexpr std::uint8_t kOb = 40;
  if (mode_ == Mode::Stop || interrupts_.isLocked(kOb)) return modules_.acknowledge(event.address);
  StartInformation start = startInformation(0x11, 0x41, priorityOf(kOb), kOb, dateAndTime());
  setByte(start, 5, direction(event));
  setWord(start, 6, event.address);
  setDWord(start, 8, event.points);
  if (!hasOb(kOb)) return obMissing(start);
  const auto& waiting = interrupts_.waiting;
  const auto& levels = machine_.levels;
  const bool busy = std::any_of(waiting.begin(), waiting.end(),
                                [&](const Request& r) { return sameModule(r.start, event); }) ||
                    std::any_of(levels.begin(), levels.end(),
                                [&](const Level& level) { return sameModule(level.start, event); });
  if (!busy) return queue(start);
  storeHardwareInterrupt(event, start);
}

// Lost for good is what is stored already: an entry, and OB 80 if it is loaded.
void Cpu::storeHardwareInterrupt(const ModuleEvent& event, const StartInformation& start) {
  auto& stored = interrupts_.stored;
  const auto at = std::find_if(stored.begin(), stored.end(), [&](const ModuleEvent& other) {
    return other.address == event.address && other.output == event.output;
  });
  if (at == stored.end()) return stored.push_back(event);
  const std::uint32_t lost = at->points & event.points;
  at->points |= event.points;
  if (lost == 0) return;
  if (hasOb(80)) return timeError(0x02, event.address, start);
  report(static_cast<std::uint16_t>(Event::RequestError), "hardware interrupt lost");
  faults_.program = true;
}

void Cpu::hardwareInterruptEnded(const StartInformation& ended) {
  modules_.acknowledge(loadWord(&ended[6]));
  auto& stored = interrupts_.stored;
  const auto at = std::find_if(stored.begin(), stored.end(),
                               [&](const ModuleEvent& event) { return sameModule(ended, event); });
  if (at == stored.end()) return;
  const ModuleEvent event = *at;
  stored.erase(at);
  hardwareInterrupt(event);
}

// S7-OBI-08: byte 6 rack 0.
void Cpu::setBattery(bool low) {
  if (faults_.battery == low) return;
  faults_.battery = low;
  asynchronousError(startInformation(low ? 0x39 : 0x38, 0x22, priorityOf(81), 81, dateAndTime()));
}

}  // namespace merker::cpu
