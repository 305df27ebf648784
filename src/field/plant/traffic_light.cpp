// The lamps of a pedestrian crossing and a button on each side of the road. DANGER counts how often
// cars and pedestrians were let go at the same time: both green, or green and red with amber.
#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "plant/silence.h"

namespace merker::plant {
namespace {

using Side = Signal::Side;

constexpr Signal kSignals[] = {
    {"CARS_RED", Side::Input, true},
    {"CARS_AMBER", Side::Input, true},
    {"CARS_GREEN", Side::Input, true},
    {"WALK_RED", Side::Input, true},
    {"WALK_GREEN", Side::Input, true},
    {"WAIT", Side::Input, true},
    {"LEFT", Side::Input, true},
    {"RIGHT", Side::Input, true},
    {"LEFT_CONTACT", Side::Output, true},
    {"RIGHT_CONTACT", Side::Output, true},
    {"DANGER", Side::Output},
};

class TrafficLight : public ProcessOf<kNoParameters, kSignals> {
 public:
  explicit TrafficLight(Parameters) {}

  void begin(Signals values) override { show(values); }

  void advance(Instant, Instant, Signals values) override {
    const bool carsGo = values["CARS_GREEN"] != 0 || values["CARS_AMBER"] != 0;
    const bool both = carsGo && values["WALK_GREEN"] != 0;
    if (both && !both_) ++dangers_;
    both_ = both;
    show(values);
  }

  double silence(Seen values) const override {
    const bool shown =
        values["LEFT_CONTACT"] == values["LEFT"] && values["RIGHT_CONTACT"] == values["RIGHT"];
    return shown ? kForever : 0;
  }

 private:
  void show(Signals values) const {
    values["LEFT_CONTACT"] = values["LEFT"];
    values["RIGHT_CONTACT"] = values["RIGHT"];
    values["DANGER"] = dangers_;
  }

  bool both_ = false;
  int dangers_ = 0;
};

}  // namespace

const Kind kTrafficLight{"traffic light", Duration::milliseconds(1), kNoParameters, kSignals,
                         make<TrafficLight>};

}  // namespace merker::plant
