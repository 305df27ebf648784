#include "cpu/quiet_cycles.h"

#include <algorithm>

namespace merker::cpu {
namespace {

using Why = NotQuiet::Why;

// After so many cycles in a row that proved nothing, some are left out before the next look.
constexpr unsigned kPatience = 4, kMostDoublings = 6;

}  // namespace

std::uint64_t ProvenCycle::fit(const QuietSpan& span) const {
  const Instant last = std::min(span.limit, holds - Duration{1});
  if (last <= end) return 0;
  const auto fitting = static_cast<std::uint64_t>((last - end).ns / length.ns);
  if (span.enough >= last) return std::min(fitting, span.most);
  const std::int64_t way = std::max<std::int64_t>((span.enough - end).ns, 1);
  const auto enough = static_cast<std::uint64_t>((way - 1) / length.ns + 1);
  return std::min({fitting, enough, span.most});
}

void QuietCycles::note(Machine& m, const Code& code) {
  for (const Look& look : code.looks) {
    if (look.at == Look::At::Date && code.source->id == BlockId{BlockKind::OB, 1}) dateRead_ = look;
    if (look.at == Look::At::Timer && look.number < m.loadedTimers.size())
      m.loadedTimers[look.number] = 1;
  }
}

bool QuietCycles::wants(std::uint64_t checkpoint) {
  if (known_ && at_.number == checkpoint) return true;
  if (rest_ == 0) return true;
  --rest_;
  forget();
  return false;
}

ProvenCycle* QuietCycles::fail(const NotQuiet& why) {
  const auto index = static_cast<std::size_t>(why.why);
  ++counts_[index];
  last_[index] = why;
  proven_ = false;
  if (why.why != Why::Outside && ++failures_ > kPatience)
    rest_ = 1u << std::min(failures_ - kPatience, kMostDoublings);
  return nullptr;
}

ProvenCycle* QuietCycles::refuse(const NotQuiet& why) {
  known_ = false;
  return fail(why);
}

// Asked again at the same checkpoint, by another call from outside: whoever kept a reference to
// memory may have written meanwhile.
ProvenCycle* QuietCycles::still(const Machine& m) {
  if (memory_.update(m, at_.relative.access)) proven_ = false;
  return proven_ ? &cycle_ : nullptr;
}

ProvenCycle* QuietCycles::judge(const Machine& m, const Checkpoint& now, const Outlook& outlook) {
  if (known_ && at_.number == now.number) return still(m);
  const StateCopy::Difference where = memory_.update(m, now.relative.access);
  const Checkpoint before = at_;
  const bool follows = known_ && now.number == before.number + 1;
  known_ = true;
  at_ = now;
  if (!follows) return fail({.why = Why::Outside});
  if (now.levels != before.levels + 1 || now.entries != before.entries)
    return fail({.why = outlook.look().at == Look::At::Error ? Why::Looked : Why::OtherOb,
                 .look = outlook.look()});
  if (dateRead_.at != Look::At::Nothing) return fail({.why = Why::Looked, .look = dateRead_});
  if (outlook.holds() <= now.clock) return fail({.why = Why::Looked, .look = outlook.look()});
  if (where) return fail({.why = Why::Memory, .where = where});
  if (now.acts != before.acts || before.nextEvent <= now.clock) return fail({.why = Why::Event});
  if (now.relative != before.relative) return fail({.why = Why::Duration});
  Look look = outlook.look();
  const Instant timers = timersHold(m, before.clock, look);
  if (timers <= now.clock) return fail({.why = Why::Looked, .look = look});
  cycle_ = {.end = now.clock,
            .holds = std::min({outlook.holds(), timers, now.nextEvent}),
            .length = now.clock - before.clock,
            .instructions = now.instructions - before.instructions};
  if (cycle_.fit({}) == 0) return fail({.why = Why::Event});
  proven_ = true;
  failures_ = 0;
  return &cycle_;
}

// The first instant after `from` at which a timer shows something else: its status, or the units of
// its time where the program can load them.
Instant QuietCycles::timersHold(const Machine& m, Instant from, Look& look) const {
  Instant holds = Instant::never();
  for (std::uint32_t i = 0; i < m.timers.size(); ++i) {
    if (!m.timers[i].started) continue;
    const Instant next = m.loadedTimers[i] != 0 ? m.timers[i].nextUnit(from) : m.timers[i].end;
    if (next <= from || next >= holds) continue;
    holds = next;
    look = {.at = Look::At::Timer, .number = i};
  }
  return holds;
}

void QuietCycles::passed(std::uint64_t cycles) {
  const Duration by = cycle_.length * static_cast<std::int64_t>(cycles);
  passed_ += cycles;
  cycle_.end = at_.clock = at_.clock + by;
  at_.number += cycles;
  at_.instructions += cycle_.instructions * cycles;
  at_.levels += cycles;
}

}  // namespace merker::cpu
