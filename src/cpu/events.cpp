// Events of time: cyclic, delayed and time-of-day interrupts, cycle monitoring (S7-CYCLE-04, -06).
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {

void Cpu::prepareInterrupts() {
  interrupts_ = {};
  for (const std::uint8_t ob : machine_.model->organizationBlocks) {
    if (!hasOb(ob)) continue;
    if (ob >= 30 && ob <= 38)
      interrupts_.cyclic.push_back(
          {.ob = ob, .milliseconds = defaultInterval(ob), .next = Instant::never()});
    if (ob >= 20 && ob <= 23) interrupts_.delay.push_back({.ob = ob});
    if (ob >= 10 && ob <= 17) interrupts_.timeOfDay.push_back({.ob = ob});
  }
}

Instant Cpu::nextEvent() const {
  Instant next = watchdog_;
  for (const CyclicInterrupt& cyclic : interrupts_.cyclic) next = std::min(next, cyclic.next);
  for (const DelayInterrupt& delay : interrupts_.delay)
    if (delay.active) next = std::min(next, delay.due);
  for (const TimeOfDayInterrupt& time : interrupts_.timeOfDay)
    if (time.active) next = std::min(next, clock_.when(time.due));
  return next;
}

// Order of what falls on the same instant: monitoring, delayed, time of day, cyclic.
void Cpu::takeEvents() {
  if (machine_.clock >= watchdog_) cycleTimeExceeded();
  takeDelayed();
  takeTimeOfDay();
  takeCyclic();
  if (mode_ == Mode::Run) startWaiting();
}

void Cpu::takeCyclic() {
  for (CyclicInterrupt& cyclic : interrupts_.cyclic) {
    while (cyclic.next <= machine_.clock) {
      const std::uint8_t ob = cyclic.ob;
      StartInformation start = startInformation(0x11, static_cast<std::uint8_t>(0x31 + ob - 30),
                                                priorityOf(ob), ob, dateAndTime());
      setWord(start, 10, static_cast<std::uint32_t>(cyclic.milliseconds));
      cyclic.next = cyclic.next + Duration::milliseconds(cyclic.milliseconds);
      request(ob, start);
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
    request(ob, start);
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
    time.due = nextTimeOfDay(time.start, time.period, now);
    time.active = time.due >= 0;
    time.expired = !time.active;
    request(ob, start);
  }
}

bool Cpu::runsOrWaits(std::uint8_t ob) const {
  const auto& waiting = interrupts_.waiting;
  const auto& levels = machine_.levels;
  return std::any_of(waiting.begin(), waiting.end(),
                     [&](const Request& r) { return r.ob == ob; }) ||
         std::any_of(levels.begin(), levels.end(),
                     [&](const Level& level) { return level.ob == ob; });
}

void Cpu::request(std::uint8_t ob, const StartInformation& start) {
  if (interrupts_.isLocked(ob) || mode_ != Mode::Run) return;
  if (!runsOrWaits(ob))
    interrupts_.waiting.push_back({.ob = ob, .priority = priorityOf(ob), .start = start});
  else
    timeError(0x02, 0, ob);  // S7-OBI-07: requested OB still being processed
}

void Cpu::cycleTimeExceeded() {
  const Duration monitoring = Duration::milliseconds(machine_.model->cycleMonitoring);
  if (watchdogWarned_) {  // S7-CYCLE-06: twice in one cycle
    report(static_cast<std::uint16_t>(Event::CycleTimeExceeded),
           std::string(text(Event::CycleTimeExceeded)), here());
    return stopByFault(Event::StopTimeError, "cycle time exceeded twice");
  }
  watchdogWarned_ = true;
  watchdog_ = watchdog_ + monitoring;
  timeError(0x01, static_cast<std::uint16_t>(machine_.model->cycleMonitoring), 1);
}

void Cpu::timeError(std::uint8_t faultId, std::uint16_t info, std::uint8_t ob) {
  const Event event = faultId == 0x01 ? Event::CycleTimeExceeded : Event::RequestError;
  report(static_cast<std::uint16_t>(event), std::string(text(event)), here());
  if (!hasOb(80)) return stopByFault(Event::StopTimeError, std::string(text(event)));
  if (runsOrWaits(80)) return;  // one OB 80 at a time; the entry above tells the rest
  StartInformation start = startInformation(0x35, faultId, 26, 80, dateAndTime());
  setWord(start, 6, info);
  setByte(start, 8, 0x11);
  setByte(start, 9, faultId);
  setByte(start, 10, priorityOf(ob));
  setByte(start, 11, ob);
  interrupts_.waiting.push_back({.ob = 80, .priority = 26, .start = start});
}

void Cpu::retrigger() {
  if (mode_ != Mode::Run) return;
  watchdog_ = machine_.clock + Duration::milliseconds(machine_.model->cycleMonitoring);
  watchdogWarned_ = false;
  machine_.interrupt();  // the horizon was the old deadline
}

}  // namespace merker::cpu
