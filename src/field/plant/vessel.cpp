// A vessel with an inlet, an outlet and two level sensors, and the two buttons beside it
// (S7-VIS-04, S7-VIS-05). START closes its contact when pressed, STOP opens it.
#include <algorithm>

#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

using Side = Signal::Side;

constexpr double kWhole = 100;  // %

constexpr Parameter kParameters[] = {
    {"stroke", Parameter::Form::Time, 20, 0.1, 3600},  // from full to empty, and back
    {"minimum", Parameter::Form::Number, 5, 0, kWhole},
    {"maximum", Parameter::Form::Number, 95, 0, kWhole},
    {"start", Parameter::Form::Number, kWhole, 0, kWhole},
};
constexpr Signal kSignals[] = {
    {"INLET", Side::Input, true},
    {"OUTLET", Side::Input, true},
    {"LAMP", Side::Input, true},
    {"HAND_FILL", Side::Input, true},  // a valve in the inlet that somebody opens
    {"START", Side::Input, true},
    {"STOP", Side::Input, true},
    {"LEVEL", Side::Output, false, 0, 0, kWhole, "%"},
    {"MIN", Side::Output, true},  // 1: liquid
    {"MAX", Side::Output, true},
    {"START_CONTACT", Side::Output, true},
    {"STOP_CONTACT", Side::Output, true},
};

class Vessel : public ProcessOf<kParameters, kSignals> {
 public:
  explicit Vessel(Parameters parameters)
      : rate_(kWhole / parameters["stroke"]),
        minimum_(parameters["minimum"]),
        maximum_(parameters["maximum"]),
        level_(parameters["start"]) {}

  void begin(Signals values) override { show(values); }

  void advance(Instant from, Instant to, Signals values) override {
    const double in = std::max(values["INLET"], values["HAND_FILL"]);
    level_ += rate_ * (in - values["OUTLET"]) * seconds(from, to);
    level_ = std::clamp(level_, 0.0, kWhole);
    show(values);
  }

 private:
  void show(Signals values) const {
    values["LEVEL"] = level_;
    values["MIN"] = level_ >= minimum_;
    values["MAX"] = level_ >= maximum_;
    values["START_CONTACT"] = values["START"];
    values["STOP_CONTACT"] = 1 - values["STOP"];
  }

  double rate_, minimum_, maximum_;  // % per second, %
  double level_;
};

}  // namespace

const Kind kVessel{"vessel", Duration::milliseconds(1), kParameters, kSignals, make<Vessel>};

}  // namespace merker::plant
