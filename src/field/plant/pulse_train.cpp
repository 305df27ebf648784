// A pulse generator at a terminal: light barrier, flow meter, fan (CNT-SIM-04). Its edges are known
// in advance, so the fastest train costs no more than the slowest. A new frequency or duty goes on
// with the phase of the old one.
#include "signal/pulse_train.h"

#include <algorithm>
#include <cmath>

#include "plant/named.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

constexpr double kHighest = 100'000;  // Hz
constexpr double kLeast = 0.001;      // Hz, below it stands

constexpr Parameter kParameters[] = {
    {"frequency", Parameter::Form::Number, 0, 0, kHighest},  // Hz
    {"duty", Parameter::Form::Number, 50, 0.1, 99.9},        // %
    {"jitter", Parameter::Form::Number, 0, 0, 49.9},         // % of the period, each edge
    {"seed", Parameter::Form::Whole, 1, 0, 4294967295},
};
constexpr Signal kSignals[] = {
    {"FREQUENCY", Signal::Side::Input, false, 0, 0, kHighest, "Hz"},
    {"DUTY", Signal::Side::Input, false, 0, 0, 100, "%"},
    {"PULSES", Signal::Side::Output, true},
};

std::int64_t thousandths(double value) { return std::llround(value * 1000); }

class PulseTrain : public ProcessOf<kParameters, kSignals> {
 public:
  explicit PulseTrain(Parameters parameters)
      : frequency_(parameters["frequency"]),
        duty_(parameters["duty"]),
        jitter_(static_cast<std::uint32_t>(std::llround(parameters["jitter"] * 10))),
        seed_(static_cast<std::uint64_t>(parameters["seed"])) {}

  void begin(Signals values) override {
    values["FREQUENCY"] = frequency_;
    values["DUTY"] = duty_;
    train(Instant{});
  }

  void advance(Instant, Instant to, Signals values) override {
    const double frequency =
        values["FREQUENCY"] < kLeast ? 0 : std::min(values["FREQUENCY"], kHighest);
    const double duty = std::clamp(values["DUTY"], 0.1, 99.9);
    if (frequency != frequency_ || duty != duty_) {
      phase_ = phaseAt(to);
      frequency_ = frequency;
      duty_ = duty;
      train(to);
    }
    values["PULSES"] = course_ != nullptr && course_->level(to);
  }

  std::shared_ptr<const signal::Signal> course(std::uint32_t) const override { return course_; }

 private:
  double phaseAt(Instant t) const {  // 0 to 1, from rising edge to rising edge
    const double turns = static_cast<double>((t - start_).ns) * 1e-9 * frequency_;
    return frequency_ == 0 ? phase_ : turns - std::floor(turns);
  }
  // The train that is at `phase_` now; none: it stands at 0.
  void train(Instant now) {
    course_ = nullptr;
    if (frequency_ == 0) return;
    start_ = now - Duration{std::llround(phase_ / frequency_ * 1e9)};
    signal::Pulses pulses = signal::pulsesOf(
        thousandths(frequency_), static_cast<std::uint32_t>(std::llround(duty_ * 10)), start_);
    pulses.jitter = std::min(jitter_, signal::mostJitter(pulses));
    pulses.seed = seed_;
    course_ = std::make_shared<signal::PulseTrain>(pulses);
  }

  double frequency_, duty_, phase_ = 0;
  std::uint32_t jitter_;
  std::uint64_t seed_;
  Instant start_;
  std::shared_ptr<const signal::Signal> course_;
};

}  // namespace

const Kind kPulseTrain{"pulse train", Duration::milliseconds(1), kParameters,
                       kSignals,      make<PulseTrain>,          nullptr,
                       true};

}  // namespace merker::plant
