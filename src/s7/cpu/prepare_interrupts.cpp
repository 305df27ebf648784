// Which interrupts exist: those whose OB is loaded, with the parameters of the CPU (S7-HWCFG-08).
#include <algorithm>

#include "cpu/cpu.h"

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

// S7-STATE-09: all that waited is discarded.
void Cpu::prepareInterrupts() {
  interrupts_ = {};
  updateInterrupts();
}

// A time-of-day interrupt that the parameters activate exists without its OB too: then OB 85 is
// called.
void Cpu::updateInterrupts() {
  const std::int64_t now = clock_.milliseconds(machine_.clock);
  Interrupts& list = interrupts_;
  const auto gone = [&](const auto& interrupt) { return !hasOb(interrupt.ob); };
  std::erase_if(list.cyclic, gone);
  std::erase_if(list.delay, gone);
  for (const std::uint8_t ob : machine_.model->organizationBlocks) {
    if (ob >= 30 && ob <= 38 && hasOb(ob) && !has(list.cyclic, ob)) {
      list.cyclic.push_back(cyclicOf(ob, parameters_));
      if (mode_ == Mode::Run) list.cyclic.back().begin(machine_.clock);
    }
    if (ob >= 20 && ob <= 23 && hasOb(ob) && !has(list.delay, ob)) list.delay.push_back({.ob = ob});
    if (ob < 10 || ob > 17 || has(list.timeOfDay, ob)) continue;
    const TimeOfDayInterrupt time = timeOfDayOf(ob, parameters_, now);
    if (hasOb(ob) || time.set) list.timeOfDay.push_back(time);
  }
}

}  // namespace merker::cpu
