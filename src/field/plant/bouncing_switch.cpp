// A push button whose contact bounces: after a change of PRESSED it opens and closes again,
// `bounces` times, evenly within `bounce_time`; then it rests.
#include <cmath>

#include "plant/named.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

constexpr Parameter kParameters[] = {
    {"bounces", Parameter::Form::Whole, 5, 0, 1000},
    {"bounce_time", Parameter::Form::Time, 0.005, 0.000001, 10},
    {"normally_closed", Parameter::Form::Flag, 0, 0, 1},
};
constexpr Signal kSignals[] = {
    {"PRESSED", Signal::Side::Input, true},
    {"CONTACT", Signal::Side::Output, true},
};

class BouncingSwitch : public ProcessOf<kParameters, kSignals> {
 public:
  explicit BouncingSwitch(Parameters parameters)
      : edges_(2 * static_cast<std::int64_t>(parameters["bounces"])),
        time_(std::llround(parameters["bounce_time"] * 1e9)),
        closed_(parameters["normally_closed"] != 0) {}

  void begin(Signals values) override { show(values, values["PRESSED"]); }

  void advance(Instant, Instant to, Signals values) override {
    if (values["PRESSED"] != pressed_) {
      pressed_ = values["PRESSED"];
      began_ = to;
      edge_ = 0;
      show(values, pressed_);
    }
    while (next() <= to) {
      ++edge_;
      show(values, edge_ % 2 == 0 ? pressed_ : 1 - pressed_);
    }
  }

  // An even number of edges, so that the contact ends where it went first.
  Instant next() const override {
    if (edge_ >= edges_) return Instant::never();
    return Instant{began_.ns + time_ * (edge_ + 1) / edges_};
  }

 private:
  // A normally closed contact opens when it is pressed (S7-HW-32).
  void show(Signals values, double pressed) const {
    values["CONTACT"] = closed_ ? 1 - pressed : pressed;
  }

  std::int64_t edges_, time_;
  bool closed_;
  double pressed_ = 0;
  Instant began_;
  std::int64_t edge_ = INT64_MAX;
};

}  // namespace

const Kind kBouncingSwitch{"bouncing switch", Duration{}, kParameters, kSignals,
                           make<BouncingSwitch>};

}  // namespace merker::plant
