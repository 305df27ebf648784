// What the operating system does when its time has come: modules, clock memory, cycle monitoring,
// interrupts (S7-CYCLE-04, -06; S7-MEM-01).
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {

Instant Cpu::nextEvent() const {
  const Instant next = std::min(clockMemory_.next(), modules_.next());
  if (mode() != Mode::Run) return next;  // S7-STATE-11
  return std::min({next, cycle_.deadline(), interrupts_.next()});
}

// Order of what falls on the same instant: modules, clock memory, monitoring, delayed, time of day,
// cyclic.
void Cpu::takeEvents() {
  takePeriphery();
  clockMemory_.update(machine_.areas, machine_.clock);
  if (mode() == Mode::Run) {
    if (cycle_.exceeded(machine_.clock)) cycleTimeExceeded();
    interrupts_.requestDue([this](const StartInformation& start) { requests_.request(start); });
  }
  if (state_.executing()) requests_.startHighest();
}

void Cpu::takePeriphery() {
  if (!powered_ || modules_.advance()) return;
  stopByFault(Event::StopCpuHardware,
              std::string(modules_.due()) + ": events at one instant without end");
}

// S7-OBI-07
void Cpu::skipTimesOfDay(std::uint8_t faultId) {
  const unsigned skipped = interrupts_.skipTimesOfDay();
  if (skipped != 0) requests_.timeError(faultId, skipped, {});
}

void Cpu::setClock(std::int64_t milliseconds) {
  clock_.set(milliseconds, machine_.clock);
  if (state_.executing()) skipTimesOfDay(0x05);
  machine_.interrupt();
}

// S7-CYCLE-06, S7-OBI-07: the time of the cycle so far, and who runs.
void Cpu::cycleTimeExceeded() {
  constexpr std::uint8_t kExceeded = 0x01;
  const std::int64_t time = (machine_.clock - cycle_.began()).ns / 1'000'000;
  if (!cycle_.extend()) {
    log_.report(Event::CycleTimeExceeded, log_.here());
    return stopByFault(Event::StopTimeError, "cycle time exceeded twice");
  }
  const StartInformation idle = startInformation(0x11, 0x03, 1, 1, log_.dateAndTime());
  requests_.timeError(kExceeded, static_cast<std::uint32_t>(time),
                      machine_.levels.empty() ? idle : machine_.levels.back().start);
}

void Cpu::retrigger() {
  if (mode() != Mode::Run) return;
  cycle_.monitor(machine_.clock);
  machine_.interrupt();  // the horizon was the old deadline
}

}  // namespace merker::cpu
