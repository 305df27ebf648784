// Passing over quiet cycles: the clock and all that counts cycles move as if they had been
// executed.
#include <algorithm>

#include "cpu/cpu.h"
#include "cpu/levels.h"

namespace merker::cpu {

// In RUN, directly behind the end of a cycle.
bool Cpu::atCheckpoint() const {
  return mode() == Mode::Run && machine_.levels.empty() && machine_.clock == cycleEnded_;
}

CycleNumber Cpu::cycleNumber() const {
  return {.checkpoint = cycle_.checkpoints(), .cycle = cycle_.count()};
}

Checkpoint Cpu::checkpoint() const {
  const Instant now = machine_.clock;
  const bool access = lastOutlook_.accesses();
  return {.clock = now,
          .number = cycleNumber(),
          .instructions = machine_.instructions,
          .levels = machine_.levelsStarted,
          .acts = modules_.acts(access),
          .entries = log_.buffer().added(),
          .nextEvent =
              std::min({clockMemory_.next(), modules_.nextVisible(access), interrupts_.next()}),
          .relative = {.sinceBegan = (now - cycle_.began()).ns,
                       .untilNext = (cycle_.next() - now).ns,
                       .untilDeadline = (cycle_.deadline() - now).ns,
                       .times = cycle_.times(),
                       .scan = cycle_.scan(),
                       .position = machine_.position,
                       .access = access}};
}

// What else a cycle can depend on and no checkpoint shows.
bool Cpu::predictable() const {
  return !timersHeld_ && requests_.waiting().empty() && !loadMemory_.downloaded() &&
         !cyclePoints_.observed() && !engine_.watched();
}

std::uint64_t Cpu::passQuiet(const QuietSpan& span) {
  if (!quiet_.enabled() || !atCheckpoint() || !quiet_.wants(cycleNumber())) return 0;
  quiet_.prepare(machine_, loadMemory_.code());
  const ProvenCycle* cycle = nullptr;
  if (!predictable())
    cycle = quiet_.refuse(cycleNumber(), {.why = NotQuiet::Why::Watched});
  else if (!modules_.steady())
    cycle = quiet_.refuse(cycleNumber(), {.why = NotQuiet::Why::Modules});
  else
    cycle = quiet_.judge(machine_, checkpoint(), lastOutlook_);
  if (cycle == nullptr) return 0;
  const std::uint64_t cycles = cycle->fit(span);
  if (cycles > 0) passOver(*cycle, cycles);
  return cycles;
}

void Cpu::passOver(const ProvenCycle& cycle, std::uint64_t cycles) {
  const Duration by = cycle.length * static_cast<std::int64_t>(cycles);
  machine_.clock = cycleEnded_ = machine_.clock + by;
  machine_.instructions += cycle.instructions * cycles;
  machine_.levelsStarted += cycles;
  cycle_.pass(cycles, by);
  modules_.passed();
  showDate(dateAt(cycle_.began()));
  quiet_.passed(cycles);
}

DateAndTime Cpu::dateAt(Instant when) const { return toDateAndTime(clock_.milliseconds(when)); }

// What OB 1 left of its start information: the last one began later. Nobody reads it before it is
// written anew; the bytes are the same all the same.
void Cpu::showDate(const DateAndTime& date) {
  std::ranges::copy(date, machine_.localStacks.front().begin() + kDateInStart);
}

// The date of OB 1 in its local data, and that of OB 1 in those of the block it has called.
void lookAtLocal(Machine& m, const Frame& frame, std::uint32_t first, std::uint32_t bytes) {
  const bool ofOb = frame.first && m.levels.size() == 1;
  if (!ofOb || !touchesDate(first, bytes)) return;
  m.outlook.until(
      m.clock, {.at = Look::At::Date, .block = m.top->code->source->id, .offset = Look::kUnknown});
}

}  // namespace merker::cpu
