// Setpoints and disturbances over time (PID-SIM-08): VALUE goes to TARGET, at once or with SLOPE,
// and a sine swings around it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

constexpr Parameter kParameters[] = {
    {"start", Parameter::Form::Number, 0, -1e9, 1e9},
};
// SLOPE in units per second, 0: at once. PERIOD in seconds.
constexpr Signal kSignals[] = {
    {"TARGET", Signal::Side::Input},    {"SLOPE", Signal::Side::Input},
    {"AMPLITUDE", Signal::Side::Input}, {"PERIOD", Signal::Side::Input, false, 60},
    {"VALUE", Signal::Side::Output},
};

class Generator : public ProcessOf<kParameters, kSignals> {
 public:
  explicit Generator(Parameters parameters) : base_(parameters["start"]) {}

  void begin(Signals values) override { values["TARGET"] = values["VALUE"] = base_; }

  void advance(Instant from, Instant to, Signals values) override {
    const double way = std::abs(values["SLOPE"]) * seconds(from, to);
    const double target = values["TARGET"];
    base_ = values["SLOPE"] == 0 ? target : std::clamp(target, base_ - way, base_ + way);
    if (values["PERIOD"] > 0)
      turns_ = std::fmod(turns_ + seconds(from, to) / values["PERIOD"], 1.0);
    values["VALUE"] = base_ + values["AMPLITUDE"] * std::sin(2 * std::numbers::pi * turns_);
  }

 private:
  double base_, turns_ = 0;
};

}  // namespace

const Kind kGenerator{"generator", Duration::milliseconds(1), kParameters, kSignals,
                      make<Generator>};

}  // namespace merker::plant
