// A run of the axis from its start to its end: travelling to the switching points, ramping down,
// turning (technology manual 3.4.1, 4.4.1). It moves the drive cycle by cycle.
#pragma once

#include <optional>

#include "positioning/drive.h"
#include "positioning/reference_search.h"

namespace merker::positioning {

// Where a run goes, and how. Without a target it is endless (rotary axis).
struct Course {
  int direction = 1;
  Motion motion;
  std::optional<std::int64_t> target;

  Ahead ahead(std::int64_t position) const;
  // No creep speed: the set-point is 0 before the cut-off point (POS-RUN-13).
  bool endsAtStandstill() const;
};

class Run {
 public:
  Run(Mode mode, const Course& course, std::int64_t startPoint)
      : mode_(mode), course_(course), startPoint_(startPoint) {}

  // A reference-point run; `back` leads to the reference point from behind the switch.
  void search(const ReferenceSearch& search, const Course& back) {
    search_ = search;
    back_ = back;
  }

  enum class Progress : std::uint8_t { Moving, CutOff, Stopped };
  Progress step(std::int64_t position, Drive& drive);
  void stop();  // ramp down to the end
  // Jog: travels on like this, turning first if the direction is the other one.
  void turnTo(const Course& course, Drive& drive);

  Mode mode() const { return mode_; }
  const Course& course() const { return course_; }
  std::int64_t startPoint() const { return startPoint_; }
  bool hasTarget() const { return mode_ == Mode::Relative || mode_ == Mode::Absolute; }
  bool changedOver() const { return changedOver_; }
  ReferenceSearch* search() { return search_ ? &*search_ : nullptr; }

 private:
  void rampDown();
  void followSearch(Drive& drive);
  Progress end(Drive& drive, Progress how);
  Progress turn(std::int64_t position, Drive& drive);
  Progress travel(std::int64_t position, Drive& drive);

  Mode mode_;
  Course course_;
  std::int64_t startPoint_;
  bool changedOver_ = false;
  bool ramping_ = false;
  std::optional<std::int64_t> rampedFrom_;  // position, from the first cycle on
  std::optional<Course> next_;              // behind the ramp
  std::optional<ReferenceSearch> search_;
  Course back_;
  bool switchHandled_ = false;
};

}  // namespace merker::positioning
