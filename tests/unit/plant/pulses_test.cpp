// Pulse trains and encoders as plants: what lies at their terminals is known in advance, and goes
// on without a lost edge when the speed changes (CNT-SIM-04, CNT-SIM-06).
#include <gtest/gtest.h>

#include "make.h"

namespace merker::plant {
namespace {

// A process by itself, with its values.
struct Alone {
  const Kind& kind;
  std::unique_ptr<Process> process;
  std::vector<double> values;
  Instant now;

  explicit Alone(const PlantSettings& settings)
      : kind(*settings.kind), process(kind.make(settings.parameters)), values(kind.signals.size()) {
    process->begin(values);
  }
  double& operator[](std::string_view signal) { return values[*kind.signal(signal)]; }
  void go(Instant to) {
    process->advance(now, to, values);
    now = to;
  }
  // Edges of the present course from now to `to`, then on.
  int edges(std::string_view signal, Instant to) {
    const auto course = process->course(*kind.signal(signal));
    int count = 0;
    for (Instant t = now; course && (t = course->next(t)) <= to; ++count) {
    }
    go(to);
    return count;
  }
};

TEST(PulseTrainPlant, stands) {
  Alone train(make("Fan", "pulse train"));
  EXPECT_EQ(train.process->course(*train.kind.signal("PULSES")), nullptr);
  train.go(at(1000));
  EXPECT_EQ(train["PULSES"], 0);
}

TEST(PulseTrainPlant, frequencyAndDuty) {
  Alone train(make("Fan", "pulse train", {{"frequency", 1000}, {"duty", 25}}));
  EXPECT_EQ(train.edges("PULSES", at(1000)), 2000);
  const auto course = train.process->course(*train.kind.signal("PULSES"));
  EXPECT_TRUE(course->level(at(2000) + Duration::microseconds(249)));
  EXPECT_FALSE(course->level(at(2000) + Duration::microseconds(251)));
}

// A ramp in steps: all periods together are the integral of the frequency.
TEST(PulseTrainPlant, changesKeepThePhase) {
  Alone train(make("Fan", "pulse train", {{"frequency", 100}}));
  int edges = 0;
  for (int ms = 1; ms <= 2000; ++ms) {
    edges += train.edges("PULSES", at(ms));
    train["FREQUENCY"] = 100 + ms * 0.1;  // up to 300 Hz
    train.go(at(ms));
  }
  EXPECT_NEAR(edges / 2.0, 400, 1);
}

// CNT-SIM-04
TEST(PulseTrainPlant, theSameSeedTheSameJitter) {
  const auto lastEdge = [](double seed) {
    Alone train(make("Fan", "pulse train", {{"frequency", 10}, {"jitter", 10}, {"seed", seed}}));
    return train.process->course(2)->last(at(1000));
  };
  EXPECT_EQ(lastEdge(7), lastEdge(7));
  EXPECT_NE(lastEdge(7), lastEdge(8));
}

TEST(EncoderPlant, tracksFollowTheSpeed) {
  Alone axis(make("Axis", "encoder", {{"increments", 500}}));
  axis["SPEED"] = 2;  // turns a second: 1000 periods
  axis.go(at(0));
  EXPECT_EQ(axis.edges("A", at(1000)), 2000);
  EXPECT_NEAR(axis["POSITION"], 2, 1e-9);
  axis["SPEED"] = -1;
  axis.go(at(1000));
  EXPECT_EQ(axis.edges("B", at(3000)), 2000);
  EXPECT_NEAR(axis["POSITION"], 0, 1e-9);
}

// Back and forth between two quarters, and slowly over them: edges are where the axis passes.
TEST(EncoderPlant, noEdgeIsLostOrInvented) {
  Alone axis(make("Axis", "encoder", {{"start", 0.3}}));  // 1.2 quarters: A is 1, B is 0
  EXPECT_EQ(axis["A"], 1);
  axis["SPEED"] = 0.1;  // 0.4 quarters a second
  axis.go(at(0));
  EXPECT_EQ(axis.edges("B", at(1000)), 0);  // at 1.6
  axis["SPEED"] = -0.1;
  axis.go(at(1000));
  EXPECT_EQ(axis.edges("A", at(2000)), 0);  // at 1.2 again
  EXPECT_EQ(axis.edges("A", at(3000)), 1);  // through 1.0 to 0.8
  EXPECT_EQ(axis["A"], 0);
}

TEST(EncoderPlant, followsAnotherAxis) {
  Alone axis(make("Axis", "encoder", {{"increments", 250}, {"follows", 1}}));
  int edges = 0;
  for (int ms = 1; ms <= 100; ++ms) {
    axis["AXIS"] = ms * 0.01;  // to 1
    edges += axis.edges("A", at(ms));
  }
  edges += axis.edges("A", at(101));
  EXPECT_NEAR(axis["POSITION"], 1, 1e-3);
  EXPECT_NEAR(edges, 500, 2);
}

// At a terminal: the course is attached, a stuck sensor takes it away, and it comes back.
TEST(PulseTrainPlant, liesAtATerminal) {
  io::Rack rack(onBoard());
  const io::Terminal input = *rack.terminal("2.2", io::Side::DigitalInput, 0);
  PlantSettings train = make("Fan", "pulse train", {{"frequency", 100}});
  wire(train, "PULSES", input);
  Plants plants(Configuration{{train}});
  const auto levels = [&](int from) {
    int high = 0;
    for (int i = 0; i < 20; ++i) {  // half periods, in their middle
      rack.settle(at(from + 5 * i) + Duration::microseconds(2500));
      high += rack.level(input) ? 1 : 0;
    }
    return high;
  };
  plants.advance(rack, at(0));
  EXPECT_EQ(levels(0), 10);
  plants.stick(rack, {0, *train.kind->signal("PULSES")}, 1, at(100));
  EXPECT_EQ(levels(100), 20);
  plants.release(rack, {0, *train.kind->signal("PULSES")}, at(200));
  EXPECT_EQ(levels(200), 10);
}

}  // namespace
}  // namespace merker::plant
