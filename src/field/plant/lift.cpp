// A lift with three floors: a motor up and down, a floor sensor at each, a door that opens while
// DOOR is on, buttons on the floors (CALL) and in the car (GO). FAULTS counts what must not happen:
// it moves with an open door, runs against its buffers, or opens the door between two floors.
#include <algorithm>
#include <array>
#include <cmath>

#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "plant/silence.h"

namespace merker::plant {
namespace {

using Side = Signal::Side;

constexpr std::size_t kFloors = 3;

constexpr double kTop = kFloors - 1.0;
constexpr double kAtFloor = 0.02;  // of the way between two floors
constexpr double kWhole = 100;     // %

constexpr Parameter kParameters[] = {
    {"floor_time", Parameter::Form::Time, 4, 0.1, 3600},  // from floor to floor
    {"door_time", Parameter::Form::Time, 1.5, 0.1, 60},   // from closed to open
    {"start", Parameter::Form::Number, 1, 1, kFloors},    // floor
};
constexpr Signal kSignals[] = {
    {"UP", Side::Input, true},
    {"DOWN", Side::Input, true},
    {"DOOR", Side::Input, true},
    {"LAMP1", Side::Input, true},
    {"LAMP2", Side::Input, true},
    {"LAMP3", Side::Input, true},
    {"CALL1", Side::Input, true},
    {"CALL2", Side::Input, true},
    {"CALL3", Side::Input, true},
    {"GO1", Side::Input, true},
    {"GO2", Side::Input, true},
    {"GO3", Side::Input, true},
    {"HEIGHT", Side::Output, false, 0, 0, kTop},  // floors above the lowest
    {"DOORWAY", Side::Output, false, 0, 0, kWhole, "%"},
    {"FLOOR1", Side::Output, true},
    {"FLOOR2", Side::Output, true},
    {"FLOOR3", Side::Output, true},
    {"DOOR_OPEN", Side::Output, true},
    {"DOOR_CLOSED", Side::Output, true},
    {"CALL1_CONTACT", Side::Output, true},
    {"CALL2_CONTACT", Side::Output, true},
    {"CALL3_CONTACT", Side::Output, true},
    {"GO1_CONTACT", Side::Output, true},
    {"GO2_CONTACT", Side::Output, true},
    {"GO3_CONTACT", Side::Output, true},
    {"FAULTS", Side::Output},
};
static_assert(areTogether(kSignals, "CALL1", "CALL3", kFloors));
static_assert(areTogether(kSignals, "GO1", "GO3", kFloors));
static_assert(areTogether(kSignals, "FLOOR1", "FLOOR3", kFloors));
static_assert(areTogether(kSignals, "CALL1_CONTACT", "CALL3_CONTACT", kFloors));
static_assert(areTogether(kSignals, "GO1_CONTACT", "GO3_CONTACT", kFloors));

class Lift : public ProcessOf<kParameters, kSignals> {
 public:
  explicit Lift(Parameters parameters)
      : speed_(1 / parameters["floor_time"]),
        doorSpeed_(kWhole / parameters["door_time"]),
        height_(std::round(parameters["start"]) - 1) {}

  void begin(Signals values) override { show(values); }

  void advance(Instant from, Instant to, Signals values) override {
    const double time = seconds(from, to);
    const double direction = values["UP"] - values["DOWN"];
    height_ = std::clamp(height_ + speed_ * direction * time, -kAtFloor, kTop + kAtFloor);
    door_ = std::clamp(door_ + doorSpeed_ * (2 * values["DOOR"] - 1) * time, 0.0, kWhole);
    judge(Forbidden::OpenWhileMoving, direction != 0 && door_ > 0);
    judge(Forbidden::Buffer, direction * (height_ - kTop / 2) >= kTop / 2 + kAtFloor);
    judge(Forbidden::OpenBetween, values["DOOR"] != 0 && !atFloor());
    show(values);
  }

  double silence(Seen values) const override {
    for (std::size_t i = 0; i < kFloors; ++i)
      if (values.from("CALL1_CONTACT")[i] != values.from("CALL1")[i] ||
          values.from("GO1_CONTACT")[i] != values.from("GO1")[i])
        return 0;
    const double speed = speed_ * (values["UP"] - values["DOWN"]);
    const double doorSpeed = doorSpeed_ * (2 * values["DOOR"] - 1);
    double seconds = secondsTo({0, kWhole}, door_, doorSpeed, 0, kWhole);
    for (double floor = 0; floor <= kTop; ++floor)
      seconds = std::min(seconds, secondsTo({floor - kAtFloor, floor + kAtFloor}, height_, speed,
                                            -kAtFloor, kTop + kAtFloor));
    return seconds;
  }

 private:
  enum class Forbidden : std::uint8_t { OpenWhileMoving, Buffer, OpenBetween };

  // Each is counted when it begins.
  void judge(Forbidden what, bool is) {
    bool& was = now_[static_cast<std::size_t>(what)];
    if (is && !was) ++faults_;
    was = is;
  }

  bool atFloor() const { return std::abs(height_ - std::round(height_)) <= kAtFloor; }

  void show(Signals values) const {
    values["HEIGHT"] = height_;
    values["DOORWAY"] = door_;
    for (std::size_t i = 0; i < kFloors; ++i) {
      values.from("FLOOR1")[i] = std::abs(height_ - static_cast<double>(i)) <= kAtFloor;
      values.from("CALL1_CONTACT")[i] = values.from("CALL1")[i];
      values.from("GO1_CONTACT")[i] = values.from("GO1")[i];
    }
    values["DOOR_OPEN"] = door_ >= kWhole;
    values["DOOR_CLOSED"] = door_ <= 0;
    values["FAULTS"] = faults_;
  }

  double speed_, doorSpeed_;  // floors per second, % per second
  double height_, door_ = 0;
  std::array<bool, 3> now_{};
  int faults_ = 0;
};

}  // namespace

const Kind kLift{"lift", Duration::milliseconds(1), kParameters, kSignals, make<Lift>};

}  // namespace merker::plant
