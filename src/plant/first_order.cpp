// A process with one lag and dead time: x' = a x + (1 - a) K u with a = exp(-dt / T), exact for an
// input that stays during a step (PID-SIM-03). PV = x + OFFSET.
#include <cmath>
#include <deque>

#include "plant/processes.h"

namespace merker::plant {
namespace {

enum { GAIN, TIME_CONSTANT, DEAD_TIME, START };
enum { LMN, DISTURBANCE, OFFSET, PV };

constexpr double kWeek = 7 * 24 * 3600.0;

constexpr Parameter kParameters[] = {
    {"gain", Parameter::Form::Number, 1, -1e6, 1e6},
    {"time_constant", Parameter::Form::Time, 20, 0.001, kWeek},
    {"dead_time", Parameter::Form::Time, 0, 0, 3600},
    {"start", Parameter::Form::Number, 0, -1e6, 1e6},
};
constexpr Signal kSignals[] = {
    {"LMN", Signal::Side::Input},
    {"DISTURBANCE", Signal::Side::Input},  // added to LMN
    {"OFFSET", Signal::Side::Input},
    {"PV", Signal::Side::Output},
};

class FirstOrder : public Process {
 public:
  explicit FirstOrder(std::span<const double> parameters)
      : gain_(parameters[GAIN]),
        lag_(parameters[TIME_CONSTANT]),
        deadTime_{static_cast<std::int64_t>(std::llround(parameters[DEAD_TIME] * 1e9))},
        state_(parameters[START]) {}

  void begin(std::span<double> values) override { values[PV] = state_ + values[OFFSET]; }

  void advance(Instant from, Instant to, std::span<double> values) override {
    const double seconds = static_cast<double>((to - from).ns) / 1e9;
    const double input = delayed(from, values[LMN] + values[DISTURBANCE]);
    state_ += (1 - std::exp(-seconds / lag_)) * (gain_ * input - state_);
    values[PV] = state_ + values[OFFSET];
  }

 private:
  struct Sample {
    Instant from;
    double input;
  };
  // The input as it was a dead time ago; nothing before the beginning.
  double delayed(Instant now, double input) {
    if (deadTime_.ns == 0) return input;
    samples_.push_back({now, input});
    while (samples_.size() > 1 && samples_[1].from + deadTime_ <= now) samples_.pop_front();
    return samples_.front().from + deadTime_ <= now ? samples_.front().input : 0;
  }

  double gain_, lag_;
  Duration deadTime_;
  double state_;
  std::deque<Sample> samples_;
};

std::unique_ptr<Process> make(std::span<const double> parameters) {
  return std::make_unique<FirstOrder>(parameters);
}

}  // namespace

const Kind kFirstOrder{"first order", Duration::milliseconds(1), kParameters, kSignals, make};

}  // namespace merker::plant
