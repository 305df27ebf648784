// Cycles that need not be computed. When a whole cycle from one checkpoint to the next has changed
// nothing, has looked at nothing but memory and has met no event, every further one is the same
// until the next event: docs/decisions/0013-quiet-cycles.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/patience.h"
#include "cpu/cycle_times.h"
#include "cpu/machine.h"
#include "cpu/outlook.h"
#include "cpu/state_copy.h"

namespace merker::cpu {

// Why a cycle was computed: what makes it no proof for the next one, or leaves no room to the next
// event.
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
    Start,     // the first one since the program began to run
    LeftOut,   // not looked at: those before it proved nothing
    Proof,     // it was the same as the one before
    kCount
  };
  Why why = Why::Outside;
  StateCopy::Difference where{};
  Look look{};
};

// Checkpoints are ends of cycles, and changes to RUN.
struct CycleNumber {
  std::uint64_t checkpoint = 0, cycle = 0;
  std::uint64_t starts() const { return checkpoint - cycle; }
  bool operator==(const CycleNumber&) const = default;
};

// What a checkpoint must have in common with the one before, beside memory.
struct Checkpoint {
  Instant clock;
  CycleNumber number;
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
  void forget() { known_ = proven_ = copied_ = false; }
  // The same, and the program may be another one.
  void forgetProgram() { forget(), prepared_ = false; }

  // At a checkpoint: whether to look at it at all. Programs that are never quiet are left alone
  // most of the time.
  bool wants(const CycleNumber& number);
  // The look. Null: the cycle that has ended proves nothing.
  ProvenCycle* judge(const Machine& machine, const Checkpoint& now, const Outlook& outlook);
  // Cannot be judged.
  ProvenCycle* refuse(const CycleNumber& number, const NotQuiet& why);
  // So many have been passed over.
  void passed(std::uint64_t cycles);

  std::uint64_t cycles() const { return passed_; }
  // Of the cycles that were computed and looked at, or left out.
  const Counts& counts() const { return counts_; }
  // How often memory was compared.
  std::uint64_t comparisons() const { return comparisons_; }
  // The last one for this reason.
  const NotQuiet& last(NotQuiet::Why why) const { return last_[static_cast<std::size_t>(why)]; }

  // Which timers a program can load, and whether OB 1 reads its date: once a program.
  template <typename Codes>
  void prepare(Machine& machine, const Codes& codes) {
    if (prepared_) return;
    prepared_ = true;
    dateRead_ = {};
    timersLoaded_.clear();
    for (const auto& code : codes) note(machine, *code);
  }

 private:
  using Why = NotQuiet::Why;
  void note(Machine& machine, const Code& code);
  void count(const CycleNumber& number, const NotQuiet& why);
  ProvenCycle* fail(const NotQuiet& why);
  ProvenCycle* begin(Why why);
  Why whyFirst() const;
  ProvenCycle* still(const Machine& machine);
  std::optional<NotQuiet> looked(const Checkpoint& before, const Outlook& outlook) const;
  ProvenCycle* prove(const Machine& machine, const Checkpoint& before, const Outlook& outlook);
  StateCopy::Difference compare(const Machine& machine);
  Look lookAt(std::uint32_t timer) const;
  Instant timersHold(const Machine& machine, Instant from, Look& look) const;

  bool enabled_ = true, prepared_ = false;
  bool known_ = false;   // at_ is a checkpoint
  bool proven_ = false;  // the cycle before it was quiet
  Look dateRead_;
  std::vector<Look> timersLoaded_;
  Checkpoint at_;
  ProvenCycle cycle_;
  StateCopy memory_;
  bool copied_ = false;  // memory_ is a copy of the memory then
  Patience patience_;
  bool leftOut_ = false;       // the cycle before
  std::uint64_t counted_ = 0;  // cycle that was counted last
  std::uint64_t starts_ = 0, comparisons_ = 0;
  std::size_t compared_ = 0;  // bytes, for this look
  std::uint64_t passed_ = 0;
  Counts counts_{};
  std::array<NotQuiet, static_cast<std::size_t>(NotQuiet::Why::kCount)> last_{};
};

}  // namespace merker::cpu
