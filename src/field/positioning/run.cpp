#include "positioning/run.h"

namespace merker::positioning {

Ahead Course::ahead(std::int64_t position) const {
  if (!target) return {};
  const Differences& differences = motion.differences.of(direction);
  const std::int64_t way = direction * (*target - position);
  return {way - differences.changeover, way - differences.cutOff};
}

bool Course::endsAtStandstill() const {
  const Differences& differences = motion.differences.of(direction);
  return differences.changeover < differences.cutOff;
}

void Run::rampDown() {
  if (!ramping_) rampedFrom_.reset();
  ramping_ = true;
}

// A search ends with it, unless the reference point has just been passed (POS-REF-18).
void Run::stop() {
  if (search_ && !search_->found()) search_.reset();
  next_.reset();
  rampDown();
}

void Run::turnTo(const Course& course, Drive& drive) {
  if (course.direction != course_.direction) {
    next_ = course;
    rampDown();
    return;
  }
  course_ = course;
  next_.reset();
  ramping_ = false;
  drive.start(course.direction, course.motion);
}

// The three examples of 3.4.4: the reference point lies ahead of the switch, or behind it, or the
// run begins on the switch (POS-REF-05 to -08).
void Run::followSearch(Drive& drive) {
  if (search_->found()) {
    next_.reset();
    rampDown();
  } else if (search_->onSwitch() && !switchHandled_) {
    switchHandled_ = true;
    if (course_.direction == search_->location()) return drive.slow();
    next_ = back_;
    rampDown();
  }
}

Run::Progress Run::step(std::int64_t position, Drive& drive) {
  if (search_) followSearch(drive);
  if (!ramping_) return travel(position, drive);
  const Ahead ahead = course_.ahead(position);
  if (ahead.changeover <= 0) changedOver_ = true;
  if (ahead.cutOff <= 0 && !course_.endsAtStandstill()) {
    if (!next_) return end(drive, Progress::CutOff);
    drive.halt();
    return turn(position, drive);
  }
  if (!rampedFrom_) rampedFrom_ = position;
  if (!drive.rampDown(course_.direction * (position - *rampedFrom_))) return Progress::Moving;
  return next_ ? turn(position, drive) : end(drive, Progress::Stopped);
}

Run::Progress Run::travel(std::int64_t position, Drive& drive) {
  const Ahead ahead = course_.ahead(position);
  if (ahead.changeover <= 0) changedOver_ = true;
  const bool atEnd = ahead.cutOff <= 0 && !course_.endsAtStandstill();
  return atEnd || drive.travel(ahead) ? end(drive, Progress::CutOff) : Progress::Moving;
}

Run::Progress Run::turn(std::int64_t position, Drive& drive) {
  course_ = *next_;
  next_.reset();
  ramping_ = false;
  drive.start(course_.direction, course_.motion);
  if (search_) drive.slow();
  return drive.pauses() ? Progress::Moving : travel(position, drive);
}

Run::Progress Run::end(Drive& drive, Progress how) {
  drive.off();
  return how;
}

}  // namespace merker::positioning
