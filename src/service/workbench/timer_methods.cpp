// S5 timers by hand (S7-SIM-13); one of them is set as any variable is.
#include "workbench/method.h"

namespace merker::workbench {
namespace timer_methods {
namespace {

using monitor::Feature;

Answer mode(const Call& call) {
  const bool manual = call.fields.flag("manual");
  if (!call.fields.good()) return call.fields.problems();
  call.monitor().holdTimers(manual);
  return empty();
}

// These, or all.
Answer reset(const Call& call) {
  const std::size_t count = call.monitor().timers();
  const bool all = !call.fields.has("timers");
  const auto last = static_cast<std::int64_t>(count) - 1;
  const auto wanted =
      all ? std::vector<std::int64_t>() : call.fields.integers("timers", 0, last, count);
  if (!call.fields.good()) return call.fields.problems();
  for (const std::int64_t number : wanted)
    call.monitor().resetTimer(static_cast<std::size_t>(number));
  for (std::size_t number = 0; all && number < count; ++number) call.monitor().resetTimer(number);
  return empty();
}

constexpr Method kMethods[] = {
    {"timers.mode", Needs::ableOn(Feature::TimersByHand), mode, Kind::Action},
    {"timers.reset", Needs::ableOn(Feature::TimersByHand), reset, Kind::Action},
};

}  // namespace
}  // namespace timer_methods

std::span<const Method> timerMethods() { return timer_methods::kMethods; }

}  // namespace merker::workbench
