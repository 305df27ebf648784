// A lift with three floors: a motor up and down, a floor sensor at each, a door that opens while
// DOOR is on, buttons on the floors (CALL) and in the car (GO). FAULTS counts what must not happen:
// it moves with an open door, runs against its buffers, or opens the door between two floors.
#include <algorithm>
#include <array>
#include <cmath>

#include "plant/delay.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

using Side = Signal::Side;

constexpr std::size_t kFloors = 3;

enum { FLOOR_TIME, DOOR_TIME, START };
enum {
  UP,
  DOWN,
  DOOR,
  LAMP1,
  CALL1 = LAMP1 + kFloors,
  GO1 = CALL1 + kFloors,
  HEIGHT = GO1 + kFloors,
  DOORWAY,
  FLOOR1,
  DOOR_OPEN = FLOOR1 + kFloors,
  DOOR_CLOSED,
  CALL1_CONTACT,
  GO1_CONTACT = CALL1_CONTACT + kFloors,
  FAULTS = GO1_CONTACT + kFloors
};

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
static_assert(std::size(kSignals) == FAULTS + 1);

class Lift : public Process {
 public:
  explicit Lift(std::span<const double> parameters)
      : speed_(1 / parameters[FLOOR_TIME]),
        doorSpeed_(kWhole / parameters[DOOR_TIME]),
        height_(std::round(parameters[START]) - 1) {}

  void begin(std::span<double> values) override { show(values); }

  void advance(Instant from, Instant to, std::span<double> values) override {
    const double time = seconds(from, to);
    const double direction = values[UP] - values[DOWN];
    height_ = std::clamp(height_ + speed_ * direction * time, -kAtFloor, kTop + kAtFloor);
    door_ = std::clamp(door_ + doorSpeed_ * (2 * values[DOOR] - 1) * time, 0.0, kWhole);
    judge(Forbidden::OpenWhileMoving, direction != 0 && door_ > 0);
    judge(Forbidden::Buffer, direction * (height_ - kTop / 2) >= kTop / 2 + kAtFloor);
    judge(Forbidden::OpenBetween, values[DOOR] != 0 && !atFloor());
    show(values);
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

  void show(std::span<double> values) const {
    values[HEIGHT] = height_;
    values[DOORWAY] = door_;
    for (std::size_t i = 0; i < kFloors; ++i) {
      values[FLOOR1 + i] = std::abs(height_ - static_cast<double>(i)) <= kAtFloor;
      values[CALL1_CONTACT + i] = values[CALL1 + i];
      values[GO1_CONTACT + i] = values[GO1 + i];
    }
    values[DOOR_OPEN] = door_ >= kWhole;
    values[DOOR_CLOSED] = door_ <= 0;
    values[FAULTS] = faults_;
  }

  double speed_, doorSpeed_;  // floors per second, % per second
  double height_, door_ = 0;
  std::array<bool, 3> now_{};
  int faults_ = 0;
};

std::unique_ptr<Process> make(std::span<const double> parameters) {
  return std::make_unique<Lift>(parameters);
}

}  // namespace

const Kind kLift{"lift", Duration::milliseconds(1), kParameters, kSignals, make};

}  // namespace merker::plant
