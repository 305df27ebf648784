// A tank with an inflow and an outflow, each steadily by a valve in % or on and off (PID-SIM-06).
// A full tank runs over, an empty one gives nothing.
#include <algorithm>

#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "plant/silence.h"

namespace merker::plant {
namespace {

constexpr double kWhole = 100;  // %

constexpr Parameter kParameters[] = {
    {"capacity", Parameter::Form::Number, 100, 1e-6, 1e9},  // litres
    {"inflow_rate", Parameter::Form::Number, 1, 0, 1e9},    // litres per second at 100 %
    {"outflow_rate", Parameter::Form::Number, 1, 0, 1e9},
    {"start", Parameter::Form::Number, 0, 0, kWhole},
};
constexpr Signal kSignals[] = {
    {"INFLOW", Signal::Side::Input, false, 0, 0, kWhole, "%"},
    {"OUTFLOW", Signal::Side::Input, false, 0, 0, kWhole, "%"},
    {"FILL", Signal::Side::Input, true},
    {"DRAIN", Signal::Side::Input, true},
    {"LEVEL", Signal::Side::Output, false, 0, 0, kWhole, "%"},
    {"FULL", Signal::Side::Output, true},
    {"EMPTY", Signal::Side::Output, true},
};

// A valve does not open further than it can.
double opening(double percent, double on) { return std::clamp(percent / kWhole + on, 0.0, 1.0); }

class Tank : public ProcessOf<kParameters, kSignals> {
 public:
  explicit Tank(Parameters parameters)
      : in_(parameters["inflow_rate"] / parameters["capacity"] * kWhole),
        out_(parameters["outflow_rate"] / parameters["capacity"] * kWhole),
        level_(parameters["start"]) {}

  void begin(Signals values) override { show(values); }

  void advance(Instant from, Instant to, Signals values) override {
    level_ = std::clamp(level_ + flow(values) * seconds(from, to), 0.0, kWhole);
    show(values);
  }

  double silence(Seen values) const override {
    return secondsTo({0, kWhole}, level_, flow(values), 0, kWhole);
  }

 private:
  template <typename Values>
  double flow(const Values& values) const {
    return in_ * opening(values["INFLOW"], values["FILL"]) -
           out_ * opening(values["OUTFLOW"], values["DRAIN"]);
  }

  void show(Signals values) const {
    values["LEVEL"] = level_;
    values["FULL"] = level_ >= kWhole;
    values["EMPTY"] = level_ <= 0;
  }

  double in_, out_;  // % of the capacity per second
  double level_;
};

}  // namespace

const Kind kTank{"tank", Duration::milliseconds(1), kParameters, kSignals, make<Tank>};

}  // namespace merker::plant
