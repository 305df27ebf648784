// The axis as a plant: what lies at its terminals is known to the nanosecond (POS-PLANT-01, -03,
// -12, -13, -17).
#include <gtest/gtest.h>

#include "make.h"
#include "signal/ramp.h"

namespace merker::plant {
namespace {

// In its steps of 4 ms; edges of one of its tracks meanwhile.
class Machine {
 public:
  explicit Machine(std::vector<Given> given = {})
      : settings_(make("Axis", "axis", std::move(given))) {
    process_ = settings_.kind->make(settings_.parameters);
    for (const Signal& signal : settings_.kind->signals) values_.push_back(signal.rest);
    process_->begin(values_);
    process_->advance(now_, now_, values_);
  }
  double& operator[](std::string_view signal) { return values_[index(signal)]; }
  std::shared_ptr<const signal::Signal> course(std::string_view signal) const {
    return process_->course(index(signal));
  }
  void steps(int count) {
    while (count-- > 0) {
      const Instant to = now_ + Duration::milliseconds(4);
      for (auto& [name, edges] : watched_) {
        const auto track = course(name);
        for (Instant t = now_; (t = track->next(t)) <= to;) edges.push_back(t);
      }
      process_->advance(now_, to, values_);
      now_ = to;
    }
  }
  void pass(Duration time) {  // less than a step
    process_->advance(now_, now_ + time, values_);
    now_ = now_ + time;
  }
  std::vector<Instant>& watch(const std::string& signal) { return watched_[signal]; }

 private:
  std::uint32_t index(std::string_view signal) const {
    return settings_.kind->signal(signal).value();
  }
  PlantSettings settings_;
  std::unique_ptr<Process> process_;
  std::vector<double> values_;
  std::map<std::string, std::vector<Instant>> watched_;
  Instant now_;
};

// 1 V: 1000 pulses/s after three steps; each edge of A and B is a pulse
TEST(AxisPlant, Tracks) {
  Machine axis;
  auto &a = axis.watch("A"), &b = axis.watch("B"), &n = axis.watch("N");
  axis["SETPOINT"] = 1;
  axis["ENABLE"] = 1;
  axis.steps(1001);
  EXPECT_DOUBLE_EQ(axis["SPEED"], 1000);
  EXPECT_DOUBLE_EQ(axis["POSITION"], 3994.8);
  EXPECT_EQ(a.size() + b.size(), 3994u);
  EXPECT_EQ(n.size(), 3u);  // the end of the first mark, and all of the second one
  EXPECT_EQ((n[2] - n[1]).ns, 3'000'000);
  axis["ENABLE"] = 0;
  axis.steps(100);
  EXPECT_DOUBLE_EQ(axis["POSITION"], 3998.8 + 100);
  const auto standing = axis.course("A");
  axis.steps(10);
  EXPECT_EQ(axis.course("A"), standing);
  EXPECT_EQ(standing->next(Instant{}), standing->next(Instant{}));
}

// Of the same instant as the position, not of the end of its step
TEST(AxisPlant, SpeedWithinAStep) {
  Machine axis;
  axis["SETPOINT"] = 1;
  axis["ENABLE"] = 1;
  axis.steps(2);
  EXPECT_DOUBLE_EQ(axis["SPEED"], 400);
  EXPECT_DOUBLE_EQ(axis["POSITION"], 0.8);
  axis.pass(Duration::milliseconds(1));
  EXPECT_DOUBLE_EQ(axis["SPEED"], 500);
  EXPECT_DOUBLE_EQ(axis["POSITION"], 1.25);
}

// The switches at their pulses, not at the next step
TEST(AxisPlant, Switches) {
  Machine axis(
      {{"start", 990}, {"workpiece_from", 1000}, {"workpiece_to", 1007}, {"high_switch", 1100}});
  auto& workpiece = axis.watch("WORKPIECE");
  axis["SETPOINT"] = 1;
  axis["ENABLE"] = 1;
  axis.steps(30);
  ASSERT_EQ(workpiece.size(), 2u);
  EXPECT_EQ((workpiece[1] - workpiece[0]).ns, 7'000'000);
  EXPECT_NE(workpiece[0].ns % 4'000'000, 0);
  axis.steps(200);
  EXPECT_EQ(axis["HIGH_SWITCH"], 1);
  EXPECT_EQ(axis["SPEED"], 0);
  axis["SETPOINT"] = -1;
  axis.steps(100);
  EXPECT_EQ(axis["HIGH_SWITCH"], 0);
  EXPECT_EQ(axis["SPEED"], -1000);
}

// POS-PLANT-22: after a turn the encoder moves alone; the edges of a switch at their nanosecond
TEST(AxisPlant, Backlash) {
  Machine axis({{"start", 990}, {"workpiece_to", 1010}, {"backlash", 20}});
  auto &workpiece = axis.watch("WORKPIECE"), &a = axis.watch("A");
  axis["SETPOINT"] = 1;
  axis["ENABLE"] = 1;
  axis.steps(26);
  ASSERT_EQ(workpiece.size(), 2u);
  EXPECT_EQ((workpiece[1] - workpiece[0]).ns, 10'000'000);
  EXPECT_EQ(axis["POSITION"], axis["ENCODER"]);
  axis["SETPOINT"] = -1;
  axis.steps(4);
  const double turned = axis["POSITION"];
  EXPECT_GT(turned, axis["ENCODER"]);
  EXPECT_LT(turned, axis["ENCODER"] + 20);
  const std::size_t counted = a.size();
  axis.steps(2);
  EXPECT_EQ(axis["POSITION"], turned) << "within the play";
  EXPECT_GE(a.size(), counted + 2);
  axis.steps(30);
  EXPECT_DOUBLE_EQ(axis["POSITION"], axis["ENCODER"] + 20);
  ASSERT_EQ(workpiece.size(), 4u);
  EXPECT_EQ((workpiece[3] - workpiece[2]).ns, 10'000'000);
}

// Contactors, hand wheel, emergency stop, blocked axis
TEST(AxisPlant, Inputs) {
  Machine axis({{"contactors", 1}});
  axis["Q0"] = axis["Q3"] = 1;
  axis.steps(200);
  EXPECT_EQ(axis["SPEED"], -10'000);
  axis["EMERGENCY_STOP"] = 1;
  axis.steps(600);
  EXPECT_EQ(axis["SPEED"], 0);
  axis["EMERGENCY_STOP"] = axis["Q0"] = axis["Q3"] = 0;
  const double position = axis["POSITION"];
  axis["HAND"] = 100;
  axis.steps(250);
  EXPECT_NEAR(axis["POSITION"] - position, 100, 2);
  axis["BLOCKED"] = 1;
  axis.steps(2);
  const double blocked = axis["POSITION"];
  axis.steps(10);
  EXPECT_EQ(axis["POSITION"], blocked);
}

}  // namespace
}  // namespace merker::plant
