#include "positioning/channel.h"

#include <algorithm>
#include <utility>

#include "positioning/analog_drive.h"
#include "positioning/digital_drive.h"
#include "positioning/error.h"
#include "positioning/soundness.h"

namespace merker::positioning {
namespace {

std::unique_ptr<Drive> driveOf(const io::AxisChannel& parameters) {
  if (parameters.output == io::AxisOutput::Digital)
    return std::make_unique<DigitalDrive>(parameters);
  return std::make_unique<AnalogDrive>(parameters);
}

}  // namespace

// With parameters that do not fit together nothing starts, so those of the default are as good.
Channel::Channel(const io::AxisChannel& parameters)
    : p_(flaw(parameters) ? io::AxisChannel{.output = parameters.output} : parameters),
      fits_(!flaw(parameters)),
      parametrised_(fits_),
      drive_(driveOf(p_)),
      position_(p_),
      length_(p_.lengthEdges),
      arrival_(p_),
      movement_(p_) {
  start();
}

void Channel::parametrise(bool sound) {
  const bool before = std::exchange(parametrised_, fits_ && sound);
  if (before && !parametrised_) abort();
}

void Channel::start() {
  run_.reset();
  interrupted_.reset();
  drive_->off();
  arrival_.reset();
  length_.reset();
  position_.reset(p_.reference);
  mode_ = Mode::None;
  driveEnabled_ = stopped_ = synchronous_ = cutOff_ = changedOver_ = false;
  insideLimits_ = insideTravel_ = true;
  errors_ = 0;
  missingPulse_ = false;
  seen_ = lastTarget_ = p_.reference;
  show();
}

void Channel::stop() {
  abort();
  show();
}

void Channel::move(std::int64_t pulses) { position_.move(pulses); }

// The reference point has its coordinate at once; the count goes on from there (POS-REF-02).
void Channel::zeroMark() {
  missingPulse_ = !position_.zeroMark() || missingPulse_;
  ReferenceSearch* search = run_ ? run_->search() : nullptr;
  if (search == nullptr || !search->zeroMark()) return;
  const std::int64_t by = p_.reference - position_.now();
  position_.shift(by);
  seen_ += by;
  synchronous_ = true;
}

void Channel::referenceSwitch(bool on) {
  if (on == referenceSwitch_) return;
  referenceSwitch_ = on;
  if (ReferenceSearch* search = run_ ? run_->search() : nullptr)
    search->switchEdge(on, position_.direction());
}

void Channel::lengthInput(bool on, std::int64_t position) {
  if (on == lengthInput_) return;
  lengthInput_ = on;
  length_.edge(on, position);
}

void Channel::cycle() {
  seen_ = position_.now();
  if (std::exchange(missingPulse_, false)) trip(kMissingPulse);
  watchLimits();
  if (run_) stepRun();
  const int direction = arrival_.waitsFor();
  trip(arrival_.step(seen_, direction == 0 ? seen_ : position_.farthest(direction)));
  if (!run_) drive_->idle();
  show();
  position_.beginCycle();
}

// A limit is left once; outside of it nothing happens again (POS-MON-06, POS-MON-16).
void Channel::watchLimits() {
  const bool travel = p_.rotary || (seen_ >= -kTravelLimit && seen_ <= kTravelLimit);
  const bool inside = !limited(p_, synchronous_) || withinLimits(p_, seen_);
  if (insideTravel_ && !travel) trip(kTravelRange);
  if (insideLimits_ && !inside) trip(kWorkingRange);
  insideTravel_ = travel;
  insideLimits_ = inside;
}

void Channel::stepRun() {
  const Run::Progress progress = run_->step(seen_, *drive_);
  changedOver_ = changedOver_ || run_->changedOver();
  if (!run_->hasTarget()) lastTarget_ = seen_;  // POS-JOG-13, POS-REF-16
  if (progress != Run::Progress::Moving) return endRun(progress);
  const int direction = run_->course().direction;
  if (movement_.stands(direction, position_.farthest(direction))) trip(kMovement);
}

void Channel::endRun(Run::Progress how) {
  const Course& course = run_->course();
  const std::int64_t cutOff = course.motion.differences.of(course.direction).cutOff;
  cutOff_ = how == Run::Progress::CutOff;
  if (run_->hasTarget() && cutOff_) arrival_.await(course.direction, *course.target);
  if (run_->hasTarget() && !cutOff_ && course.direction * (*course.target - seen_) > cutOff)
    interrupted_ = Interrupted{course, run_->startPoint()};
  run_.reset();
}

void Channel::trip(std::uint16_t errors) {
  errors_ |= errors;
  if ((errors & kDesynchronising) != 0) synchronous_ = false;
  if ((errors & kAborting) != 0) abort();
}

// POS-END-06
void Channel::abort() {
  if (run_) drive_->abort();
  run_.reset();
  interrupted_.reset();
  arrival_.stopWaiting();
  lastTarget_ = seen_;
}

void Channel::control(bool driveEnabled, bool stop) {
  if (driveEnabled_ && !driveEnabled) abort();
  if (stop && run_) run_->stop();
  driveEnabled_ = driveEnabled;
  stopped_ = stop;
}

void Channel::acknowledge() { errors_ = 0; }

void Channel::selectMode(std::int32_t mode) {
  const bool known = mode == 1 || (mode >= 3 && mode <= 5);
  if (!run_ && known) mode_ = static_cast<Mode>(mode);
}

std::int32_t Channel::analogValue() const {
  constexpr std::int64_t kRated = 27'648;
  const std::int64_t full = p_.highestSpeed * kThousandths;
  const std::int64_t twice = 2 * outputs_.setPoint * kRated;
  return static_cast<std::int32_t>((twice + (twice < 0 ? -full : full)) / (2 * full));
}

Image Channel::image() const {
  const auto value = [](std::int64_t wide) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(wide, INT32_MIN, INT32_MAX));
  };
  Image image;
  image.working = run_.has_value();
  image.positionReached = arrival_.reached();
  image.measured = length_.done();
  image.synchronous = synchronous_;
  image.parametrised = parametrised_;
  image.down = position_.down();
  image.cutOff = cutOff_;
  image.changedOver = changedOver_;
  image.rampDown = run_ && drive_->decelerates();
  image.rampUp = run_ && drive_->accelerates();
  image.mode = mode_;
  image.errors = errors_;
  image.position = value(shown(seen_, p_));
  image.distanceToGo = value(lastTarget_ - seen_);
  image.lastTarget = value(shown(lastTarget_, p_));
  image.measureBegin = value(shown(length_.begin(), p_));
  image.measureEnd = value(shown(length_.end(), p_));
  image.length = value(length_.length());
  // In jog mode a run does not matter (POS-RUN-28).
  image.startEnabled =
      parametrised_ && !stopped_ && errors_ == 0 && driveEnabled_ && (!run_ || mode_ == Mode::Jog);
  return image;
}

}  // namespace merker::positioning
