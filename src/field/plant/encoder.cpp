// An incremental encoder on a moving axis (CNT-SIM-06). The axis turns with SPEED, or follows an
// axis that another plant moves; the tracks are known in advance for as long as the speed stays.
#include "signal/encoder.h"

#include <algorithm>
#include <cmath>

#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

constexpr double kFastest = 100'000'000;  // mHz of a track
constexpr double kQuarters = 4;           // of a period

constexpr Parameter kParameters[] = {
    {"increments", Parameter::Form::Number, 1, 1e-3, 1e6},  // periods of a track each unit
    {"follows", Parameter::Form::Flag, 0, 0, 1},            // the position that AXIS shows
    {"start", Parameter::Form::Number, 0, -1e6, 1e6},
};
constexpr Signal kSignals[] = {
    {"SPEED", Signal::Side::Input, false, 0, 0, 100, "1/s"},
    {"AXIS", Signal::Side::Input},
    {"POSITION", Signal::Side::Output},
    {"A", Signal::Side::Output, true},
    {"B", Signal::Side::Output, true},
};

class Encoder : public ProcessOf<kParameters, kSignals> {
 public:
  explicit Encoder(Parameters parameters)
      : quartersEach_(parameters["increments"] * kQuarters),
        follows_(parameters["follows"] != 0),
        quarters_(parameters["start"] * quartersEach_) {}

  void begin(Signals values) override {
    values["AXIS"] = quarters_ / quartersEach_;
    turn(Instant{}, 0);
    show(Instant{}, values);
  }

  void advance(Instant from, Instant to, Signals values) override {
    quarters_ += static_cast<double>(millihertz_) * 1e-3 * kQuarters * seconds(from, to);
    if (!follows_)
      turn(to, values["SPEED"] * quartersEach_);
    else if (from < to)  // there by the end of the next step
      turn(to, (values["AXIS"] * quartersEach_ - quarters_) / seconds(from, to));
    show(to, values);
  }

  std::shared_ptr<const signal::Signal> course(std::uint32_t signal) const override {
    return signal == Signals::at("A") ? a_ : signal == Signals::at("B") ? b_ : nullptr;
  }

 private:
  // From now on with so many quarters a second.
  void turn(Instant now, double speed) {
    const double wanted = std::clamp(speed / kQuarters * 1e3, -kFastest, kFastest);
    const std::int64_t millihertz = std::llround(wanted);
    if (millihertz == millihertz_ && a_ != nullptr) return;
    millihertz_ = millihertz;
    const signal::Motion motion = motionAt(now);
    a_ = std::make_shared<signal::EncoderTrack>(motion, signal::Track::A);
    b_ = std::make_shared<signal::EncoderTrack>(motion, signal::Track::B);
  }

  // The axis stands between two quarters: the next one is passed after the rest of the way.
  signal::Motion motionAt(Instant now) const {
    const double whole = std::floor(quarters_), part = quarters_ - whole;
    signal::Motion motion{now, std::llround(whole), millihertz_};
    if (millihertz_ == 0) return motion;
    const double each = 1e12 / (kQuarters * std::abs(static_cast<double>(millihertz_)));  // ns
    motion.start = now - Duration{std::llround((millihertz_ > 0 ? part : 1 - part) * each)};
    return motion;
  }

  void show(Instant now, Signals values) const {
    values["POSITION"] = quarters_ / quartersEach_;
    values["A"] = a_->level(now);
    values["B"] = b_->level(now);
  }

  double quartersEach_;
  bool follows_;
  double quarters_;
  std::int64_t millihertz_ = 0;
  std::shared_ptr<const signal::Signal> a_, b_;
};

}  // namespace

const Kind kEncoder{
    "encoder", Duration::milliseconds(1), kParameters, kSignals, make<Encoder>, nullptr, true};

}  // namespace merker::plant
