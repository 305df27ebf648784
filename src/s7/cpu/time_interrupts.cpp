#include "cpu/time_interrupts.h"

#include <algorithm>

namespace merker::cpu {

void TimeInterrupts::beginCyclic() {
  for (CyclicInterrupt& cyclic : list_.cyclic) cyclic.begin(machine_.clock);
}

void TimeInterrupts::delay(Duration by) {
  for (CyclicInterrupt& cyclic : list_.cyclic)
    if (cyclic.next != Instant::never()) cyclic.next = cyclic.next + by;
  for (DelayInterrupt& delay : list_.delay) delay.due = delay.due + by;
}

Instant TimeInterrupts::next() const {
  Instant next = Instant::never();
  for (const CyclicInterrupt& cyclic : list_.cyclic) next = std::min(next, cyclic.next);
  for (const DelayInterrupt& delay : list_.delay)
    if (delay.active) next = std::min(next, delay.due);
  for (const TimeOfDayInterrupt& time : list_.timeOfDay)
    if (time.active) next = std::min(next, clock_.when(time.due, machine_.clock));
  return next;
}

void TimeInterrupts::requestDue(const Request& request) {
  requestDelayed(request);
  requestTimesOfDay(request);
  requestCyclic(request);
}

// Event numbers 16#11 … of OB 10 …, 16#21 … of OB 20 …, 16#31 … of OB 30 ….
StartInformation TimeInterrupts::startOf(std::uint8_t ob) const {
  const auto number = static_cast<std::uint8_t>(ob / 10 * 0x10 + ob % 10 + 1);
  return startInformation(0x11, number, priorityOf(ob), ob,
                          toDateAndTime(clock_.milliseconds(machine_.clock)));
}

void TimeInterrupts::requestDelayed(const Request& request) {
  for (DelayInterrupt& delay : list_.delay) {
    if (!delay.active || delay.due > machine_.clock) continue;
    StartInformation start = startOf(delay.ob);
    setWord(start, 6, delay.sign);
    setDWord(start, 8, delay.milliseconds);
    delay.active = false;
    delay.finished = true;
    request(start);
  }
}

void TimeInterrupts::requestTimesOfDay(const Request& request) {
  const std::int64_t now = clock_.milliseconds(machine_.clock);
  for (TimeOfDayInterrupt& time : list_.timeOfDay) {
    if (!time.active || time.due > now) continue;
    StartInformation start = startOf(time.ob);
    setWord(start, 6, static_cast<std::uint32_t>(time.period));
    time.moveOn(now);
    request(start);
  }
}

void TimeInterrupts::requestCyclic(const Request& request) {
  for (CyclicInterrupt& cyclic : list_.cyclic) {
    while (cyclic.next <= machine_.clock) {
      StartInformation start = startOf(cyclic.ob);
      setWord(start, 6, static_cast<std::uint32_t>(cyclic.phase));
      setWord(start, 10, static_cast<std::uint32_t>(cyclic.milliseconds));
      cyclic.next = cyclic.next + Duration::milliseconds(cyclic.milliseconds);
      request(start);
    }
  }
}

unsigned TimeInterrupts::skipTimesOfDay() {
  const std::int64_t now = clock_.milliseconds(machine_.clock);
  unsigned skipped = 0;
  for (TimeOfDayInterrupt& time : list_.timeOfDay) {
    if (!time.active || time.due >= now) continue;
    skipped |= 1u << (time.ob - 10);
    time.moveOn(now);
  }
  return skipped;
}

}  // namespace merker::cpu
