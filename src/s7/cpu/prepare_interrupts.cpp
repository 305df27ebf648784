// Which interrupts of time exist: those whose OB is loaded, with the parameters of the CPU
// (S7-HWCFG-08).
#include <algorithm>

#include "cpu/levels.h"
#include "cpu/time_interrupts.h"

namespace merker::cpu {
namespace {

CyclicInterrupt cyclicOf(std::uint8_t ob, const CpuParameters& parameters) {
  CyclicInterrupt result{
      .ob = ob, .milliseconds = defaultInterval(ob), .next = Instant::never(), .phase = 0};
  for (const CyclicParameter& row : parameters.cyclic)
    if (row.ob == ob) result.milliseconds = row.interval, result.phase = row.phase;
  return result;
}

TimeOfDayInterrupt timeOfDayOf(std::uint8_t ob, const CpuParameters& parameters, std::int64_t now) {
  TimeOfDayInterrupt result{.ob = ob};
  for (const TimeOfDayParameter& row : parameters.timeOfDay) {
    if (row.ob != ob || !row.active) continue;
    result.set = true;
    result.period = static_cast<Period>(row.period);
    result.start = row.start;
    result.moveOn(now);
  }
  return result;
}

template <typename Interrupt>
bool has(const std::vector<Interrupt>& list, std::uint8_t ob) {
  return std::any_of(list.begin(), list.end(), [&](const Interrupt& i) { return i.ob == ob; });
}

}  // namespace

void TimeInterrupts::prepare() {
  list_ = {};
  update(false);
}

// A time-of-day interrupt that the parameters activate exists without its OB too: then OB 85 is
// called.
void TimeInterrupts::update(bool run) {
  const std::int64_t now = clock_.milliseconds(machine_.clock);
  Interrupts& list = list_;
  const auto gone = [&](const auto& interrupt) { return !hasOb(machine_, interrupt.ob); };
  std::erase_if(list.cyclic, gone);
  std::erase_if(list.delay, gone);
  for (const std::uint8_t ob : machine_.model->organizationBlocks) {
    if (ob >= 30 && ob <= 38 && hasOb(machine_, ob) && !has(list.cyclic, ob)) {
      list.cyclic.push_back(cyclicOf(ob, parameters_));
      if (run) list.cyclic.back().begin(machine_.clock);
    }
    if (ob >= 20 && ob <= 23 && hasOb(machine_, ob) && !has(list.delay, ob))
      list.delay.push_back({.ob = ob});
    if (ob < 10 || ob > 17 || has(list.timeOfDay, ob)) continue;
    const TimeOfDayInterrupt time = timeOfDayOf(ob, parameters_, now);
    if (hasOb(machine_, ob) || time.set) list.timeOfDay.push_back(time);
  }
}

// When they are due is nothing to trust a file with.
void TimeInterrupts::take(const Interrupts& from, Duration shift) {
  const Instant now = machine_.clock;
  for (CyclicInterrupt& cyclic : list_.cyclic) {
    cyclic.begin(now);
    const auto same = [&](const CyclicInterrupt& one) { return one.ob == cyclic.ob; };
    const auto old = std::ranges::find_if(from.cyclic, same);
    if (old != from.cyclic.end()) cyclic.next = std::clamp(old->next + shift, now, cyclic.next);
  }
  for (const DelayInterrupt& old : from.delay)
    if (DelayInterrupt* delay = list_.findDelay(old.ob)) {
      *delay = old;
      delay->due = old.due + shift;
    }
  for (const TimeOfDayInterrupt& old : from.timeOfDay)
    if (TimeOfDayInterrupt* time = list_.findTimeOfDay(old.ob)) *time = old;
  list_.locked = from.locked;
}

}  // namespace merker::cpu
