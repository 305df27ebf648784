// What a block orders: starts and jobs (technology manual 3.4.3 to 3.4.9).
#include "positioning/channel.h"
#include "positioning/error.h"

namespace merker::positioning {

Situation Channel::situation() const {
  Situation now;
  now.parametrised = parametrised_;
  now.driveEnabled = driveEnabled_;
  now.stopped = stopped_;
  now.working = run_.has_value();
  now.synchronous = synchronous_;
  now.onSwitch = referenceSwitch_;
  now.active = mode_;
  now.errors = errors_;
  now.position = seen_;
  now.lastTarget = lastTarget_;
  now.interrupted = interrupted_;
  return now;
}

std::uint16_t Channel::begin(const Request& request) {
  const Decision decision = decide(p_, situation(), request);
  if (const auto* error = std::get_if<std::uint16_t>(&decision)) return *error;
  execute(std::get<Plan>(decision));
  return kNoError;
}

// POS-RUN-03. A jog run that is still on turns, or takes on what is new.
void Channel::execute(const Plan& plan) {
  mode_ = plan.mode;
  arrival_.reset();
  interrupted_.reset();
  cutOff_ = false;
  changedOver_ = plan.travels && plan.course.ahead(seen_).changeover <= 0;
  const bool hasTarget = plan.mode == Mode::Relative || plan.mode == Mode::Absolute;
  lastTarget_ = hasTarget ? *plan.course.target : seen_;
  if (!plan.travels) return arrival_.arrive(lastTarget_);
  if (run_) return run_->turnTo(plan.course, *drive_);
  run_.emplace(plan.mode, plan.course, plan.startPoint);
  if (plan.mode == Mode::Reference) {
    synchronous_ = false;
    run_->search({plan.back.direction, referenceSwitch_}, plan.back);
  }
  movement_.reset();
  drive_->start(plan.course.direction, plan.course.motion);
}

void Channel::endJog() {
  if (run_ && run_->mode() == Mode::Jog) run_->stop();
}

std::uint16_t Channel::job(std::int32_t id, std::int32_t value) {
  constexpr std::int32_t kSetReference = 1, kDeleteDistance = 2;
  if (!parametrised_) return kJobNotParametrised;
  if (run_) return kJobWhilePositioning;
  if (id == kSetReference) return setReference(value);
  if (id != kDeleteDistance) return kUnknownJob;
  deleteDistance();
  return kNoError;
}

// Targets move with the coordinates, so the distance to go stays (POS-JOB-06 to -11).
std::uint16_t Channel::setReference(std::int32_t value) {
  if (p_.rotary && (value < 0 || value >= p_.rotaryEnd)) return kReferenceNotOnAxis;
  if (!p_.rotary) {
    if (!withinLimits(p_, value)) return kReferenceOutside;
    const std::int64_t target = value + lastTarget_ - seen_;
    if (target < -kTravelLimit) return kReferenceTooLow;
    if (target > kTravelLimit) return kReferenceTooHigh;
    const std::int64_t begin = interrupted_ ? value + interrupted_->startPoint - seen_ : 0;
    if (begin < -kTravelLimit) return kReferenceStartTooLow;
    if (begin > kTravelLimit) return kReferenceStartTooHigh;
  }
  const std::int64_t by = value - shown(seen_, p_);
  position_.shift(by);
  arrival_.shift(by);
  seen_ += by;
  lastTarget_ += by;
  if (interrupted_) {
    interrupted_->startPoint += by;
    *interrupted_->course.target += by;
  }
  synchronous_ = true;
  return kNoError;
}

// The next relative run begins at the actual position (POS-JOB-15 to -17).
void Channel::deleteDistance() {
  interrupted_.reset();
  arrival_.stopWaiting();
  lastTarget_ = seen_;
}

}  // namespace merker::positioning
