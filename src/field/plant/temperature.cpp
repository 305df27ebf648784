// A process that is heated and cooled: two lags in series and dead time, with a gain of its own for
// each direction (PID-SIM-04). PV = AMBIENT + what heating and cooling make of it.
#include "plant/delay.h"
#include "plant/lag.h"
#include "plant/named.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

constexpr double kDay = 24 * 3600.0;
constexpr double kRoom = 20;  // degC

constexpr Parameter kParameters[] = {
    {"heating_gain", Parameter::Form::Number, 3, 0, 1e6},  // degC per %
    {"cooling_gain", Parameter::Form::Number, 1.5, 0, 1e6},
    {"first_time_constant", Parameter::Form::Time, 60, 0.001, kDay},
    {"second_time_constant", Parameter::Form::Time, 10, 0.001, kDay},
    {"dead_time", Parameter::Form::Time, 0, 0, 3600},
};
// LMN in %, below 0 it cools; HEAT and COOL are +100 % and -100 %.
constexpr Signal kSignals[] = {
    {"LMN", Signal::Side::Input, false, 0, 0, 100, "%"},
    {"HEAT", Signal::Side::Input, true},
    {"COOL", Signal::Side::Input, true},
    {"DISTURBANCE", Signal::Side::Input, false, 0, 0, 100, "%"},
    {"AMBIENT", Signal::Side::Input, false, kRoom, 0, 100, "degC"},
    {"PV", Signal::Side::Output, false, kRoom, 0, 400, "degC"},
};

class Temperature : public ProcessOf<kParameters, kSignals> {
 public:
  explicit Temperature(Parameters parameters)
      : heating_(parameters["heating_gain"]),
        cooling_(parameters["cooling_gain"]),
        first_(parameters["first_time_constant"]),
        second_(parameters["second_time_constant"]),
        delay_(parameters["dead_time"]) {}

  void begin(Signals values) override { values["PV"] = values["AMBIENT"]; }

  void advance(Instant from, Instant to, Signals values) override {
    const double wanted =
        values["LMN"] + 100 * (values["HEAT"] - values["COOL"]) + values["DISTURBANCE"];
    const double u = delay_(from, wanted);
    const double time = seconds(from, to);
    const double target = (u >= 0 ? heating_ : cooling_) * u;
    heater_ += first_.share(time) * (target - heater_);
    above_ += second_.share(time) * (heater_ - above_);
    values["PV"] = values["AMBIENT"] + above_;
  }

 private:
  double heating_, cooling_;
  Lag first_, second_;
  Delay delay_;
  double heater_ = 0, above_ = 0;
};

}  // namespace

const Kind kTemperature{"temperature", Duration::milliseconds(1), kParameters, kSignals,
                        make<Temperature>};

}  // namespace merker::plant
