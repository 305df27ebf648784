// A vessel with an inlet, an outlet and two level sensors, and the two buttons beside it
// (S7-VIS-04, S7-VIS-05). START closes its contact when pressed, STOP opens it.
#include <algorithm>

#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "plant/silence.h"

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
    level_ += speed(values) * seconds(from, to);
    level_ = std::clamp(level_, 0.0, kWhole);
    show(values);
  }

  double silence(Seen values) const override {
    const bool shown =
        values["START_CONTACT"] == values["START"] && values["STOP_CONTACT"] == 1 - values["STOP"];
    return shown ? secondsTo({minimum_, maximum_}, level_, speed(values), 0, kWhole) : 0;
  }

 private:
  template <typename Values>
  double speed(const Values& values) const {
    return rate_ * (std::max(values["INLET"], values["HAND_FILL"]) - values["OUTLET"]);
  }

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
