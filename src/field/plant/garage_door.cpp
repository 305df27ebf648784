// A garage door with a motor, two end switches, a light barrier across the opening and a push
// button. UP and DOWN together are a mistake of the program: it stands still, and BOTH says so. A
// door that comes down on an obstacle stops on it, and HITS counts it.
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
    {"travel_time", Parameter::Form::Time, 10, 0.1, 3600},        // from closed to open
    {"obstacle_height", Parameter::Form::Number, 40, 1, kWhole},  // % of the opening
    {"start", Parameter::Form::Number, 0, 0, kWhole},             // 0: closed
};
constexpr Signal kSignals[] = {
    {"UP", Side::Input, true},       {"DOWN", Side::Input, true},
    {"LAMP", Side::Input, true},     {"BUTTON", Side::Input, true},
    {"OBSTACLE", Side::Input, true}, {"POSITION", Side::Output, false, 0, 0, kWhole, "%"},
    {"OPEN", Side::Output, true},    {"CLOSED", Side::Output, true},
    {"BARRIER", Side::Output, true},  // 0: interrupted
    {"CONTACT", Side::Output, true}, {"BOTH", Side::Output, true},
    {"HITS", Side::Output},
};

class GarageDoor : public ProcessOf<kParameters, kSignals> {
 public:
  explicit GarageDoor(Parameters parameters)
      : speed_(kWhole / parameters["travel_time"]),
        height_(parameters["obstacle_height"]),
        position_(parameters["start"]) {}

  void begin(Signals values) override { show(values); }

  void advance(Instant from, Instant to, Signals values) override {
    const double way = speed_ * (values["UP"] - values["DOWN"]) * seconds(from, to);
    // What gets under a door that is lower than it is, is not there.
    const bool stops = values["OBSTACLE"] != 0 && position_ >= height_;
    const double lowest = stops ? height_ : 0;
    const bool on = stops && way < 0 && position_ + way < lowest;
    if (on && !onObstacle_) ++hits_;
    onObstacle_ = on || (onObstacle_ && way == 0 && stops);
    position_ = std::clamp(position_ + way, lowest, kWhole);
    show(values);
  }

  // An obstacle only keeps the door from its end switch.
  double silence(Seen values) const override {
    const bool both = values["UP"] != 0 && values["DOWN"] != 0;
    const bool shown = values["BARRIER"] == 1 - values["OBSTACLE"] &&
                       values["CONTACT"] == values["BUTTON"] && (values["BOTH"] != 0) == both;
    const double speed = speed_ * (values["UP"] - values["DOWN"]);
    return shown ? secondsTo({0, kWhole}, position_, speed, 0, kWhole) : 0;
  }

 private:
  void show(Signals values) const {
    values["POSITION"] = position_;
    values["OPEN"] = position_ >= kWhole;
    values["CLOSED"] = position_ <= 0;
    values["BARRIER"] = 1 - values["OBSTACLE"];
    values["CONTACT"] = values["BUTTON"];
    values["BOTH"] = values["UP"] != 0 && values["DOWN"] != 0;
    values["HITS"] = hits_;
  }

  double speed_, height_;  // % per second, %
  double position_;
  bool onObstacle_ = false;
  int hits_ = 0;
};

}  // namespace

const Kind kGarageDoor{"garage door", Duration::milliseconds(1), kParameters, kSignals,
                       make<GarageDoor>};

}  // namespace merker::plant
