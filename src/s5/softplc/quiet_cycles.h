// Cycles of the call raster that need not be computed: when one from checkpoint to checkpoint has
// changed nothing, has met no event and has called no macro, every further one is the same until
// the next event (docs/decisions/0013-quiet-cycles.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/patience.h"
#include "softplc/machine.h"
#include "softplc/run_times.h"

namespace merker::sinumerik {

// Why a cycle was computed: what makes it no proof for the next one.
enum class NotQuiet : std::uint8_t {
  Outside,   // the first one since something outside was asked or changed
  Memory,    // flags, images, timers, counters or blocks are not what they were
  Event,     // the blink clock, a timer or a job within the next cycle
  Level,     // OB 2, an alarm or a message
  Macro,     // a function macro was called
  Duration,  // it took another time, or was not one call raster
  Watched,   // each instruction is looked at or counted; or the PLC is chopping
  Start,     // the first one since the program began to run
  LeftOut,   // not looked at: those before it proved nothing
  Proof,     // it was the same as the one before
  kCount
};

// Where memory first is not what it was: a byte of an image, a flag, a timer, a word of segment 6.
struct Difference {
  std::string_view area;  // "M", "T", "DB"; empty: there is none
  std::uint16_t number = 0, word = 0;
};

// What two checkpoints must have in common beside memory.
struct Checkpoint {
  Instant clock;
  std::uint64_t number = 0, cycle = 0;  // of checkpoints, of cycles that have ended
  std::uint64_t instructions = 0, levels = 0, macros = 0, alarms = 0;  // that there have been
  Instant nextEvent;
  struct Relative {
    std::int64_t sinceBegan = 0, untilSample = 0, untilThird = 0;
    RunTimes times{};
    bool requested = false, blink = false;
    std::uint8_t level = 0;
    std::uint32_t lastWord = 0;
    bool operator==(const Relative&) const = default;
  };
  Relative relative{};
};

class QuietCycles {
 public:
  using Counts = std::array<std::uint64_t, static_cast<std::size_t>(NotQuiet::kCount)>;

  bool on = false;
  // Something outside may have changed anything.
  void forget() { known_ = proven_ = false; }
  // Whether to look at this checkpoint: programs that are never quiet are left alone mostly.
  bool wants(std::uint64_t number, std::uint64_t cycle);
  // How many cycles like the last one end before the next event and not later than `limit`.
  std::uint64_t judge(const Machine& machine, const Checkpoint& now, Duration raster,
                      Instant limit);
  void refuse(std::uint64_t cycle, NotQuiet why);
  void passed(std::uint64_t cycles);
  std::uint64_t instructions() const { return perCycle_; }  // of one

  std::uint64_t cycles() const { return passed_; }
  const Counts& counts() const { return counts_; }
  const Difference& lastDifference() const { return where_; }

 private:
  void count(std::uint64_t cycle, NotQuiet why);
  NotQuiet whyFirst();
  bool remember(const Machine& machine);
  bool prove(const Machine& machine, const Checkpoint& now, Duration raster);
  bool fail(NotQuiet why);

  bool known_ = false, proven_ = false;
  Checkpoint at_;
  Duration length_{};
  std::uint64_t perCycle_ = 0, levelsPerCycle_ = 0;
  std::vector<std::uint8_t> memory_, next_;  // copies; the second is filled and compared
  Patience patience_;
  bool leftOut_ = false;  // the cycle before
  std::uint64_t counted_ = 0, starts_ = 0, passed_ = 0;
  Difference found_, where_;  // the last one at all, and of a cycle that proved nothing by it
  Counts counts_{};
};

}  // namespace merker::sinumerik
