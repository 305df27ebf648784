// Events of time: cyclic, delayed and time-of-day interrupts, cycle monitoring, clock memory, and
// the modules' own instants (S7-CYCLE-04, -06; S7-MEM-01).
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {

Instant Cpu::nextEvent() const {
  Instant next = std::min(clockMemory_.next(), modules_.next());
  if (mode_ != Mode::Run) return next;  // S7-STATE-11
  next = std::min(next, monitoring_.deadline());
  for (const CyclicInterrupt& cyclic : interrupts_.cyclic) next = std::min(next, cyclic.next);
  for (const DelayInterrupt& delay : interrupts_.delay)
    if (delay.active) next = std::min(next, delay.due);
  for (const TimeOfDayInterrupt& time : interrupts_.timeOfDay)
    if (time.active) next = std::min(next, clock_.when(time.due));
  return next;
}

// Order of what falls on the same instant: modules, clock memory, monitoring, delayed, time of day,
// cyclic.
void Cpu::takeEvents() {
  takePeriphery();
  clockMemory_.update(machine_.areas, machine_.clock);
  if (mode_ == Mode::Run) {
    if (monitoring_.exceeded(machine_.clock)) cycleTimeExceeded();
    takeDelayed();
    takeTimeOfDay();
    takeCyclic();
  }
  if (executes(mode_)) startWaiting();
}

void Cpu::takePeriphery() {
  if (!powered_ || modules_.advance()) return;
  stopByFault(Event::StopCpuHardware,
              std::string(modules_.due()) + ": events at one instant without end");
}

void Cpu::takeCyclic() {
  for (CyclicInterrupt& cyclic : interrupts_.cyclic) {
    while (cyclic.next <= machine_.clock) {
      const std::uint8_t ob = cyclic.ob;
      StartInformation start = startInformation(0x11, static_cast<std::uint8_t>(0x31 + ob - 30),
                                                priorityOf(ob), ob, dateAndTime());
      setWord(start, 6, static_cast<std::uint32_t>(cyclic.phase));
      setWord(start, 10, static_cast<std::uint32_t>(cyclic.milliseconds));
      cyclic.next = cyclic.next + Duration::milliseconds(cyclic.milliseconds);
      request(start);
    }
  }
}

void Cpu::takeDelayed() {
  for (DelayInterrupt& delay : interrupts_.delay) {
    if (!delay.active || delay.due > machine_.clock) continue;
    const std::uint8_t ob = delay.ob;
    StartInformation start = startInformation(0x11, static_cast<std::uint8_t>(0x21 + ob - 20),
                                              priorityOf(ob), ob, dateAndTime());
    setWord(start, 6, delay.sign);
    setDWord(start, 8, delay.milliseconds);
    delay.active = false;
    delay.finished = true;
    request(start);
  }
}

void Cpu::takeTimeOfDay() {
  const std::int64_t now = clock_.milliseconds(machine_.clock);
  for (TimeOfDayInterrupt& time : interrupts_.timeOfDay) {
    if (!time.active || time.due > now) continue;
    const std::uint8_t ob = time.ob;
    StartInformation start = startInformation(0x11, static_cast<std::uint8_t>(0x11 + ob - 10),
                                              priorityOf(ob), ob, dateAndTime());
    setWord(start, 6, static_cast<std::uint32_t>(time.period));
    time.moveOn(now);
    request(start);
  }
}

// S7-OBI-07: times that were jumped over do not start their OB; bit n of the information stands
// for OB 10 + n.
void Cpu::skipTimeOfDay(std::uint8_t faultId) {
  const std::int64_t now = clock_.milliseconds(machine_.clock);
  unsigned skipped = 0;
  for (TimeOfDayInterrupt& time : interrupts_.timeOfDay) {
    if (!time.active || time.due >= now) continue;
    skipped |= 1u << (time.ob - 10);
    time.moveOn(now);
  }
  if (skipped != 0) timeError(faultId, skipped, {});
}

void Cpu::setClock(std::int64_t milliseconds) {
  clock_.set(milliseconds, machine_.clock);
  if (executes(mode_)) skipTimeOfDay(0x05);
  machine_.interrupt();
}

// S7-CYCLE-06, S7-OBI-07: the time of the cycle so far, and who runs.
void Cpu::cycleTimeExceeded() {
  constexpr std::uint8_t kExceeded = 0x01;
  const std::int64_t time = (machine_.clock - cycleStart_).ns / 1'000'000;
  if (!monitoring_.extend()) {
    report(static_cast<std::uint16_t>(Event::CycleTimeExceeded),
           std::string(text(Event::CycleTimeExceeded)), here());
    return stopByFault(Event::StopTimeError, "cycle time exceeded twice");
  }
  const StartInformation idle = startInformation(0x11, 0x03, 1, 1, dateAndTime());
  timeError(kExceeded, static_cast<std::uint32_t>(time),
            machine_.levels.empty() ? idle : machine_.levels.back().start);
}

void Cpu::retrigger() {
  if (mode_ != Mode::Run) return;
  monitoring_.begin(machine_.clock, cycleMonitoring());
  machine_.interrupt();  // the horizon was the old deadline
}

}  // namespace merker::cpu
