// A push button whose contact bounces: after a change of PRESSED it opens and closes again,
// `bounces` times, evenly within `bounce_time`; then it rests.
#include <cmath>

#include "plant/processes.h"

namespace merker::plant {
namespace {

enum { BOUNCES, BOUNCE_TIME, NORMALLY_CLOSED };
enum { PRESSED, CONTACT };

constexpr Parameter kParameters[] = {
    {"bounces", Parameter::Form::Whole, 5, 0, 1000},
    {"bounce_time", Parameter::Form::Time, 0.005, 0.000001, 10},
    {"normally_closed", Parameter::Form::Flag, 0, 0, 1},
};
constexpr Signal kSignals[] = {
    {"PRESSED", Signal::Side::Input, true},
    {"CONTACT", Signal::Side::Output, true},
};

class BouncingSwitch : public Process {
 public:
  explicit BouncingSwitch(std::span<const double> parameters)
      : edges_(2 * static_cast<std::int64_t>(parameters[BOUNCES])),
        time_(std::llround(parameters[BOUNCE_TIME] * 1e9)),
        closed_(parameters[NORMALLY_CLOSED] != 0) {}

  void begin(std::span<double> values) override { show(values, values[PRESSED]); }

  void advance(Instant, Instant to, std::span<double> values) override {
    if (values[PRESSED] != pressed_) {
      pressed_ = values[PRESSED];
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
  void show(std::span<double> values, double pressed) const {
    values[CONTACT] = closed_ ? 1 - pressed : pressed;
  }

  std::int64_t edges_, time_;
  bool closed_;
  double pressed_ = 0;
  Instant began_;
  std::int64_t edge_ = INT64_MAX;
};

std::unique_ptr<Process> make(std::span<const double> parameters) {
  return std::make_unique<BouncingSwitch>(parameters);
}

}  // namespace

const Kind kBouncingSwitch{"bouncing switch", Duration{}, kParameters, kSignals, make};

}  // namespace merker::plant
