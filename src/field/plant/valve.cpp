// A valve with a motor and two end switches (PID-SIM-05). It moves while one of UP and DOWN is on;
// both together are a mistake of the program: it stands still, and BOTH says so.
#include <algorithm>

#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "plant/silence.h"

namespace merker::plant {
namespace {

constexpr double kWhole = 100;  // %

constexpr Parameter kParameters[] = {
    {"travel_time", Parameter::Form::Time, 30, 0.01, 3600},  // from stop to stop
    {"backlash", Parameter::Form::Number, 0, 0, 50},         // % that the motor turns in vain
    {"start", Parameter::Form::Number, 0, 0, kWhole},
};
constexpr Signal kSignals[] = {
    {"UP", Signal::Side::Input, true},
    {"DOWN", Signal::Side::Input, true},
    {"STUCK", Signal::Side::Input, true},
    {"POSITION", Signal::Side::Output, false, 0, 0, kWhole, "%"},
    {"LMNR_HS", Signal::Side::Output, true},
    {"LMNR_LS", Signal::Side::Output, true},
    {"BOTH", Signal::Side::Output, true},
};

class Valve : public ProcessOf<kParameters, kSignals> {
 public:
  explicit Valve(Parameters parameters)
      : travelTime_(parameters["travel_time"]),
        backlash_(parameters["backlash"]),
        motor_(parameters["start"]),
        position_(motor_) {}

  void begin(Signals values) override { show(values); }

  void advance(Instant from, Instant to, Signals values) override {
    values["BOTH"] = values["UP"] != 0 && values["DOWN"] != 0;
    const double way = kWhole / travelTime_ * seconds(from, to) * (values["UP"] - values["DOWN"]);
    if (values["STUCK"] == 0) move(way);
    show(values);
  }

  double silence(Seen values) const override {
    const bool both = values["UP"] != 0 && values["DOWN"] != 0;
    if ((values["BOTH"] != 0) != both) return 0;
    const double direction = values["STUCK"] == 0 ? values["UP"] - values["DOWN"] : 0;
    return secondsTo({0, kWhole}, motor_, kWhole / travelTime_ * direction, 0, kWhole);
  }

 private:
  // The motor takes the valve along at either end of the backlash; at a stop both are there.
  void move(double way) {
    motor_ = std::clamp(motor_ + way, 0.0, kWhole);
    position_ = std::clamp(position_, motor_ - backlash_, motor_);
    if (motor_ == kWhole || motor_ == 0) position_ = motor_;
  }

  void show(Signals values) const {
    values["POSITION"] = position_;
    values["LMNR_HS"] = motor_ >= kWhole;
    values["LMNR_LS"] = motor_ <= 0;
  }

  double travelTime_, backlash_, motor_, position_;
};

}  // namespace

const Kind kValve{"valve", Duration::milliseconds(1), kParameters, kSignals, make<Valve>};

}  // namespace merker::plant
