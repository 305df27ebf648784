#include "cpu/quiet_cycles.h"

#include <algorithm>

namespace merker::cpu {
namespace {

using Why = NotQuiet::Why;

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
    if (look.at != Look::At::Timer || look.number >= m.loadedTimers.size()) continue;
    m.loadedTimers[look.number] = 1;
    timersLoaded_.push_back(look);
  }
}

// Each cycle once, however often it is asked for.
void QuietCycles::count(const CycleNumber& number, const NotQuiet& why) {
  if (number.cycle == counted_) return;
  counted_ = number.cycle;
  const auto index = static_cast<std::size_t>(why.why);
  ++counts_[index];
  last_[index] = why;
}

bool QuietCycles::wants(const CycleNumber& number) {
  if (known_ && at_.number == number) return true;
  if (patience_.wants()) return true;
  forget();
  leftOut_ = true;
  count(number, {.why = Why::LeftOut});
  return false;
}

ProvenCycle* QuietCycles::fail(const NotQuiet& why) {
  count(at_.number, why);
  proven_ = false;
  patience_.failed(compared_);
  return nullptr;
}

// Nothing to compare with yet.
ProvenCycle* QuietCycles::begin(Why why) {
  count(at_.number, {.why = why});
  proven_ = leftOut_ = false;
  starts_ = at_.number.starts();
  return nullptr;
}

Why QuietCycles::whyFirst() const {
  if (leftOut_) return Why::LeftOut;
  return at_.number.starts() != starts_ ? Why::Start : Why::Outside;
}

ProvenCycle* QuietCycles::refuse(const CycleNumber& number, const NotQuiet& why) {
  at_.number = number;
  known_ = copied_ = false;
  compared_ = 0;
  return fail(why);
}

StateCopy::Difference QuietCycles::compare(const Machine& m) {
  ++comparisons_;
  copied_ = true;
  const StateCopy::Difference where = memory_.update(m, at_.relative.access);
  compared_ = memory_.bytes();
  return where;
}

// Asked again at the same checkpoint, by another call from outside: whoever kept a reference to
// memory may have written meanwhile.
ProvenCycle* QuietCycles::still(const Machine& m) {
  if (copied_ && compare(m)) proven_ = false;
  return proven_ ? &cycle_ : nullptr;
}

// What costs nothing to ask. Where nothing is expected to be quiet, memory is copied only behind a
// cycle that passes here.
ProvenCycle* QuietCycles::judge(const Machine& m, const Checkpoint& now, const Outlook& outlook) {
  if (known_ && at_.number == now.number) return still(m);
  const Checkpoint before = at_;
  const bool follows = known_ && now.number.checkpoint == before.number.checkpoint + 1;
  known_ = true;
  at_ = now;
  compared_ = 0;
  const auto why = follows ? looked(before, outlook) : std::nullopt;
  if (follows && !why) return prove(m, before, outlook);
  copied_ = false;
  if (!patience_.lost()) compare(m);
  return follows ? fail(*why) : begin(whyFirst());
}

std::optional<NotQuiet> QuietCycles::looked(const Checkpoint& before,
                                            const Outlook& outlook) const {
  if (at_.levels != before.levels + 1 || at_.entries != before.entries)
    return NotQuiet{.why = outlook.look().at == Look::At::Error ? Why::Looked : Why::OtherOb,
                    .look = outlook.look()};
  if (dateRead_.at != Look::At::Nothing) return NotQuiet{.why = Why::Looked, .look = dateRead_};
  if (outlook.holds() <= at_.clock) return NotQuiet{.why = Why::Looked, .look = outlook.look()};
  return std::nullopt;
}

ProvenCycle* QuietCycles::prove(const Machine& m, const Checkpoint& before,
                                const Outlook& outlook) {
  const bool copied = copied_;
  const StateCopy::Difference where = compare(m);
  if (!copied) return begin(Why::LeftOut);
  if (where) return fail({.why = Why::Memory, .where = where});
  if (at_.acts != before.acts || before.nextEvent <= at_.clock) return fail({.why = Why::Event});
  if (at_.relative != before.relative) return fail({.why = Why::Duration});
  Look look = outlook.look();
  const Instant timers = timersHold(m, before.clock, look);
  if (timers <= at_.clock) return fail({.why = Why::Looked, .look = look});
  cycle_ = {.end = at_.clock,
            .holds = std::min({outlook.holds(), timers, at_.nextEvent}),
            .length = at_.clock - before.clock,
            .instructions = at_.instructions - before.instructions};
  if (cycle_.fit({}) == 0) return fail({.why = Why::Event});
  count(at_.number, {.why = Why::Proof});
  proven_ = true;
  patience_.found();
  return &cycle_;
}

// The instruction that loads its time, if the program has one.
Look QuietCycles::lookAt(std::uint32_t timer) const {
  const auto found = std::ranges::find(timersLoaded_, timer, &Look::number);
  return found != timersLoaded_.end() ? *found : Look{.at = Look::At::Timer, .number = timer};
}

// The first instant after `from` at which a timer shows something else: its status, or the units of
// its time where the program can load them.
Instant QuietCycles::timersHold(const Machine& m, Instant from, Look& look) const {
  Instant holds = Instant::never();
  std::uint32_t at = 0;
  for (const std::uint32_t i : memory_.startedTimers()) {
    const Instant next = m.loadedTimers[i] != 0 ? m.timers[i].nextUnit(from) : m.timers[i].end;
    if (next <= from || next >= holds) continue;
    holds = next;
    at = i;
  }
  if (holds < Instant::never()) look = lookAt(at);
  return holds;
}

void QuietCycles::passed(std::uint64_t cycles) {
  const Duration by = cycle_.length * static_cast<std::int64_t>(cycles);
  passed_ += cycles;
  cycle_.end = at_.clock = at_.clock + by;
  at_.number.checkpoint += cycles;
  at_.number.cycle += cycles;
  at_.instructions += cycle_.instructions * cycles;
  at_.levels += cycles;
}

}  // namespace merker::cpu
