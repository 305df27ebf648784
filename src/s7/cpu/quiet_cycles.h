// Cycles that need not be computed. When a whole cycle from one checkpoint to the next has changed
// nothing, has looked at nothing but memory and has met no event, every further one is the same
// until the next event: docs/decisions/0013-quiet-cycles.md.
#pragma once

#include <array>
#include <cstdint>

#include "cpu/cycle_times.h"
#include "cpu/machine.h"
#include "cpu/outlook.h"
#include "cpu/state_copy.h"

namespace merker::cpu {

// Why a cycle was computed and is no proof for the next one, or why the next event left no room.
struct NotQuiet {
  enum class Why : std::uint8_t {
    Outside,   // the first one since something outside was asked or changed
    Memory,    // `where` is not what it was
    Looked,    // `look`
    OtherOb,   // an OB besides OB 1 ran
    Event,     // modules or clock memory changed something, or will within a cycle
    Duration,  // it took another time than the one before
    Modules,   // inputs are a function of time
    Watched,   // each instruction is looked at: probes, coverage, checks
    kCount
  };
  Why why = Why::Outside;
  StateCopy::Difference where{};
  Look look{};
};

// What a checkpoint must have in common with the one before, beside memory.
struct Checkpoint {
  Instant clock;
  std::uint64_t number = 0;                                           // ScanCycle::checkpoints
  std::uint64_t instructions = 0, levels = 0, acts = 0, entries = 0;  // that there have been
  Instant nextEvent;                                                  // as it was seen then

  // The same at both.
  struct Relative {
    std::int64_t sinceBegan = 0, untilNext = 0, untilDeadline = 0;
    CycleTimes times{};
    std::uint8_t scan = 0;
    std::uint32_t position = 0;
    bool access = false;  // to inputs behind the process image
    bool operator==(const Relative&) const = default;
  };
  Relative relative{};
};

// How far cycles may be passed over: none that ends later than `limit`, none behind the first that
// ends at `enough` or later, at most so many.
struct QuietSpan {
  Instant limit = Instant::never(), enough = Instant::never();
  std::uint64_t most = UINT64_MAX;
};

// A cycle that is known.
struct ProvenCycle {
  Instant end;    // of the first one
  Instant holds;  // the first instant that may be different
  Duration length{};
  std::uint64_t instructions = 0;
  // How many more end before it.
  std::uint64_t fit(const QuietSpan& span) const;
};

class QuietCycles {
 public:
  using Counts = std::array<std::uint64_t, static_cast<std::size_t>(NotQuiet::Why::kCount)>;

  void enable(bool on) { enabled_ = on; }
  bool enabled() const { return enabled_; }
  // Something outside may have changed anything.
  void forget() { known_ = proven_ = false; }
  // The same, and the program may be another one.
  void forgetProgram() { forget(), prepared_ = false; }

  // At a checkpoint: whether to look at it at all. Programs that are never quiet are left alone
  // most of the time.
  bool wants(std::uint64_t checkpoint);
  // The look. Null: the cycle that has ended proves nothing.
  ProvenCycle* judge(const Machine& machine, const Checkpoint& now, const Outlook& outlook);
  // Cannot be judged.
  ProvenCycle* refuse(const NotQuiet& why);
  // So many have been passed over.
  void passed(std::uint64_t cycles);

  std::uint64_t cycles() const { return passed_; }
  const Counts& counts() const { return counts_; }
  // The last one for this reason.
  const NotQuiet& last(NotQuiet::Why why) const { return last_[static_cast<std::size_t>(why)]; }

  // Which timers a program can load, and whether OB 1 reads its date: once a program.
  template <typename Codes>
  void prepare(Machine& machine, const Codes& codes) {
    if (prepared_) return;
    prepared_ = true;
    dateRead_ = {};
    for (const auto& code : codes) note(machine, *code);
  }

 private:
  void note(Machine& machine, const Code& code);
  ProvenCycle* fail(const NotQuiet& why);
  ProvenCycle* still(const Machine& machine);
  Instant timersHold(const Machine& machine, Instant from, Look& look) const;

  bool enabled_ = true, prepared_ = false;
  bool known_ = false;   // last_ and the copy are those of a checkpoint
  bool proven_ = false;  // the cycle before it was quiet
  Look dateRead_;
  Checkpoint at_;
  ProvenCycle cycle_;
  StateCopy memory_;
  unsigned failures_ = 0, rest_ = 0;
  std::uint64_t passed_ = 0;
  Counts counts_{};
  std::array<NotQuiet, static_cast<std::size_t>(NotQuiet::Why::kCount)> last_{};
};

}  // namespace merker::cpu
