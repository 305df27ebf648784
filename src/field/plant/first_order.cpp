// A process with one lag and dead time: x' = a x + (1 - a) K u with a = exp(-dt / T), exact for an
// input that stays during a step (PID-SIM-03). PV = x + OFFSET + noise.
#include <random>

#include "plant/delay.h"
#include "plant/lag.h"
#include "plant/named.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

constexpr double kWeek = 7 * 24 * 3600.0;

constexpr Parameter kParameters[] = {
    {"gain", Parameter::Form::Number, 1, -1e6, 1e6},
    {"time_constant", Parameter::Form::Time, 20, 0.001, kWeek},
    {"dead_time", Parameter::Form::Time, 0, 0, 3600},
    {"start", Parameter::Form::Number, 0, -1e6, 1e6},
    {"noise", Parameter::Form::Number, 0, 0, 1e6},
    {"seed", Parameter::Form::Whole, 1, 0, 4294967295},
};
constexpr Signal kSignals[] = {
    {"LMN", Signal::Side::Input},
    {"DISTURBANCE", Signal::Side::Input},
    {"OFFSET", Signal::Side::Input},
    {"PV", Signal::Side::Output},
};

class FirstOrder : public ProcessOf<kParameters, kSignals> {
 public:
  explicit FirstOrder(Parameters parameters)
      : gain_(parameters["gain"]),
        lag_(parameters["time_constant"]),
        noise_(parameters["noise"]),
        delay_(parameters["dead_time"]),
        state_(parameters["start"]),
        random_(static_cast<std::uint32_t>(parameters["seed"])) {}

  void begin(Signals values) override { values["PV"] = state_ + values["OFFSET"]; }

  void advance(Instant from, Instant to, Signals values) override {
    const double input = delay_(from, values["LMN"] + values["DISTURBANCE"]);
    state_ += lag_.share(seconds(from, to)) * (gain_ * input - state_);
    values["PV"] = state_ + values["OFFSET"] + noise();
  }

 private:
  // Evenly between -noise and +noise, the same for the same seed everywhere.
  double noise() {
    if (noise_ == 0) return 0;
    return noise_ * (static_cast<double>(random_()) / 2147483647.5 - 1);
  }

  double gain_;
  Lag lag_;
  double noise_;
  Delay delay_;
  double state_;
  std::mt19937 random_;
};

}  // namespace

const Kind kFirstOrder{"first order", Duration::milliseconds(1), kParameters, kSignals,
                       make<FirstOrder>};

}  // namespace merker::plant
