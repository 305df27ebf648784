// S5 timers by hand (S7-SIM-13); one of them is set as any variable is.
#include "cpu/cpu.h"
#include "workbench/method.h"

namespace merker::workbench {
namespace {

using monitor::Feature;

Answer mode(const Call& call) {
  const bool manual = call.fields.flag("manual");
  if (!call.fields.good()) return call.fields.problems();
  call.station().cpu().holdTimers(manual);
  return empty();
}

// These, or all.
Answer reset(const Call& call) {
  cpu::Cpu& cpu = call.station().cpu();
  std::vector<cpu::S5Timer>& timers = cpu.machine().timers;
  const bool all = !call.fields.has("timers");
  const auto last = static_cast<std::int64_t>(timers.size()) - 1;
  const auto wanted =
      all ? std::vector<std::int64_t>() : call.fields.integers("timers", 0, last, timers.size());
  if (!call.fields.good()) return call.fields.problems();
  for (const std::int64_t number : wanted) timers[static_cast<std::size_t>(number)].reset(true);
  if (all)
    for (cpu::S5Timer& timer : timers) timer.reset(true);
  return empty();
}

constexpr Method kMethods[] = {
    {"timers.mode", Needs::ableOn(Feature::TimersByHand), mode, Kind::Action},
    {"timers.reset", Needs::ableOn(Feature::TimersByHand), reset, Kind::Action},
};

}  // namespace

std::span<const Method> timerMethods() { return kMethods; }

}  // namespace merker::workbench
