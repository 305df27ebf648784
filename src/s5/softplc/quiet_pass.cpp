// Passing over quiet cycles: clock, raster and all that counts move as if they had been executed.
#include <algorithm>

#include "softplc/operating_system.h"

namespace merker::sinumerik {

// In RUN, directly behind the end of a cycle.
bool OperatingSystem::atCheckpoint() const {
  return mode() == Mode::Run && betweenCycles() && machine_.clock == cycleEnded_;
}

// What a cycle can depend on and no checkpoint shows.
bool OperatingSystem::predictable() const {
  return !recorder_.active() && !probes_.any() && !cyclePoints_.observed() && changes_.empty() &&
         !processor_.stpSeen() && !active_.bit(data_bit::kChopping) && alarmLevel_.quiet() &&
         !state_.holdsNext();
}

// When something happens that is not in each cycle: a timer counts, the blink clock turns, a job
// goes on.
Instant OperatingSystem::nextEvent() const {
  Instant next = options_.macros != nullptr ? options_.macros->next() : Instant::never();
  for (const Timer& timer : machine_.timers) next = std::min(next, timer.next());
  return std::min(next, schedule_.ipoClock(flags_.clocksUntilBlink()));
}

Checkpoint OperatingSystem::checkpoint() const {
  const Instant now = machine_.clock;
  return {.clock = now,
          .number = checkpoints_,
          .cycle = cycles_,
          .instructions = processor_.instructions(),
          .levels = processor_.levels(),
          .macros = processor_.macroCalls(),
          .alarms = raised_ + record_.alarms().history().size(),
          .nextEvent = nextEvent(),
          .relative = {.sinceBegan = (now - watch_.start()).ns,
                       .untilSample = (schedule_.nextSample() - now).ns,
                       .untilThird = (schedule_.nextThird() - now).ns,
                       .times = times_,
                       .requested = requested_,
                       .blink = flags_.blink(),
                       .level = flags_.level(),
                       .lastWord = processor_.lastWord()}};
}

void OperatingSystem::passQuiet(Instant limit, std::uint64_t most) {
  if (!quiet_.on || !atCheckpoint() || !quiet_.wants(checkpoints_, cycles_)) return;
  if (!predictable()) return quiet_.refuse(cycles_, NotQuiet::Watched);
  const Raster& raster = schedule_.raster();
  const std::uint64_t cycles =
      std::min(quiet_.judge(machine_, checkpoint(), raster.call, limit), most);
  if (cycles == 0) return;
  const Duration by = raster.call * static_cast<std::int64_t>(cycles);
  machine_.clock = cycleEnded_ = machine_.clock + by;
  processor_.pass(cycles, quiet_.instructions());
  schedule_.pass(cycles);
  flags_.pass(cycles * raster.factor);
  watch_.delay(by);
  cycles_ += cycles;
  checkpoints_ += cycles;
  quiet_.passed(cycles);
}

}  // namespace merker::sinumerik
