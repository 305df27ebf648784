// How virtual time follows the clock on the wall. That clock is an argument here.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "plc/controller.h"

namespace merker::workbench {

enum class PaceMode : std::uint8_t { Real, Fast, Pause };

struct Pace {
  PaceMode mode = PaceMode::Real;
  double factor = 1;  // of real time
  bool operator==(const Pace&) const = default;
};

// Something that is due at an instant of virtual time.
struct Schedule {
  std::function<Instant()> next = [] { return Instant::never(); };
  std::function<void()> run = [] {};
};

class Pacer {
 public:
  // Nanoseconds of a clock on the wall that never goes back.
  using WallClock = std::function<std::int64_t()>;

  const Pace& pace() const { return pace_; }
  void set(Pace pace) { pace_ = pace, restart(); }
  // Cycles to run one by one while time is paused.
  void step(std::uint64_t cycles) { steps_ += cycles; }
  bool stepping() const { return steps_ > 0; }
  double reached() const { return pace_.mode == PaceMode::Pause ? 0 : reached_; }
  // Time begins anew: another PLC, or time did not move for a while.
  void restart() { running_ = false, steps_ = 0, cycle_.reset(); }
  // Somebody else has moved virtual time.
  void rebase() { running_ = false; }

  // One slice of at most `longest` on the wall. True: there is more to do at once.
  bool advance(controller::Controller& plc, const WallClock& wall, Duration longest,
               const Schedule& schedule = {});

 private:
  void begin(const controller::Controller& plc, std::int64_t now);
  void measure(const controller::Controller& plc, std::int64_t now);
  bool stepCycles(controller::Controller& plc, const WallClock& wall, std::int64_t end,
                  const Schedule& schedule);

  bool stepCycle(controller::Controller& plc, const WallClock& wall, std::int64_t end,
                 const Schedule& schedule);
  void portion(controller::Controller& plc, Instant target, const Schedule& schedule,
               const std::function<bool()>& tooLong);

  // A cycle that runs by itself.
  struct Cycle {
    std::uint64_t number;
    Instant latest;
  };

  Pace pace_;
  std::optional<Cycle> cycle_;
  std::uint64_t steps_ = 0;
  bool running_ = false;
  std::int64_t wallOrigin_ = 0, measuredAt_ = 0;
  Instant origin_, measured_;
  double reached_ = 0;
};

}  // namespace merker::workbench
