// Runs of a small project: what parameters change and measures see.
#include "campaign/run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace merker::campaign {
namespace {

namespace fs = std::filesystem;

// A tank that MW 10 = 1 fills, 1 % a second unless varied; Q 124.0 is on above MW 12 %.
constexpr const char* kProject = R"([cpu]
model = "314C-2 PtP"
[[module]]
slot = "2.2"
name = "Panel"
[[module]]
slot = "2.3"
name = "Analog"
range = "0..10V"
[[plant]]
name = "Tank"
kind = "tank"
[plant.wire]
FILL = "Panel.DO0"
FULL = "Panel.DI0"
[[plant]]
name = "Noise"
kind = "first order"
noise = 1.0
)";
constexpr const char* kProgram = R"(ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     MW 10
      L     1
      ==I
      =     A 124.0
      L     MD 20
      T     MD 24
END_ORGANIZATION_BLOCK
)";

class Runs : public testing::Test {
 protected:
  Runs() {
    fs::create_directory(folder_);
    write("merker.toml", kProject);
    write("a.awl", kProgram);
  }
  ~Runs() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  Plan plan(const std::string& text) {
    Plan plan = tryPlan(text);
    EXPECT_TRUE(problems_.empty()) << (problems_.empty() ? "" : problems_.list().front().message);
    return plan;
  }
  Plan tryPlan(const std::string& text) {
    problems_ = {};
    const source::SourceFile file((folder_ / "sweep.toml").string(), text);
    Plan plan(readDefinition(file, problems_), problems_);
    if (!problems_.hasErrors()) plan.bind("1.0", problems_);
    return plan;
  }
  static Outcome run(const Plan& plan, std::uint64_t number) {
    campaign::Run run(plan);
    run.begin(plan.choice(number));
    return run.end(plan.choice(number));
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("merker-runs-" + std::to_string(getpid()));
  Problems problems_;
};

constexpr const char* kSweep = R"([campaign]
for = "10s"
[campaign.vary]
"plant.Tank.inflow_rate" = [1, 2]
"set.MW 10" = [0, 1]
[campaign.measure]
level = "max plant Tank.LEVEL"
high = "time plant.tank.level > 5"
since = "when plant Tank.LEVEL >= 5"
filled = "count A 124.0 changes"
mean = "mean A 124.0"
area = "integral |MW 10|"
[campaign.require]
level = "<= 15"
)";

TEST_F(Runs, AreMeasured) {
  const Plan one = plan(kSweep);
  const Outcome slow = run(one, 1);
  EXPECT_TRUE(slow.passed) << slow.message;
  EXPECT_NEAR(*slow.measures[0], 10, 0.01);  // 1 l/s of 100 l for 10 s
  EXPECT_NEAR(*slow.measures[1], 5, 0.01);
  EXPECT_NEAR(*slow.measures[2], 5, 0.01);
  EXPECT_NEAR(*slow.measures[4], 1, 0.001);
  EXPECT_NEAR(*slow.measures[5], 10, 0.01);
  const Outcome empty = run(one, 0);
  EXPECT_EQ(empty.measures[0], 0);
  EXPECT_FALSE(empty.measures[2]);  // never
  EXPECT_EQ(empty.measures[3], 0);
}

// Each word of a measure that kSweep does not have. What has no type is a number without a sign.
TEST_F(Runs, AreMeasuredByEveryWord) {
  write("data.awl",
        "DATA_BLOCK DB 9\nSTRUCT\n n : INT := -3;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n");
  const Plan one = plan(
      "[campaign]\nfor = \"1s\"\nrepeat = 1\n[campaign.measure]\na = \"min DB9.n\"\n"
      "b = \"max |DB9.n|\"\nc = \"cycles\"\nd = \"instructions\"\ne = \"last DB9.DBW 0\"\n");
  const Outcome outcome = run(one, 0);
  EXPECT_EQ(outcome.measures[0], -3);
  EXPECT_EQ(outcome.measures[1], 3);
  EXPECT_EQ(outcome.measures[2], static_cast<double>(outcome.cycles));
  EXPECT_GT(*outcome.measures[3], *outcome.measures[2]) << "more than one a cycle";
  EXPECT_EQ(outcome.measures[4], 65533);
}

TEST_F(Runs, FailByWhatIsRequired) {
  const Outcome quick = run(plan(kSweep), 3);
  EXPECT_FALSE(quick.passed);
  EXPECT_TRUE(quick.message.starts_with("level is 19.99")) << quick.message;
  EXPECT_TRUE(quick.message.ends_with(", required is <= 15"));
}

TEST_F(Runs, KnowNothingOfEachOther) {
  const Plan one = plan(kSweep);
  campaign::Run several(one);
  for (const std::uint64_t number : {3u, 0u, 1u, 3u}) {
    several.begin(one.choice(number));
    EXPECT_EQ(several.end(one.choice(number)), run(one, number)) << number;
  }
}

TEST_F(Runs, ThatDifferLateHaveOneBeginning) {
  const Plan one = plan(kSweep);
  EXPECT_EQ(one.beginning(0), one.beginning(1));
  EXPECT_NE(one.beginning(0), one.beginning(2));
}

TEST_F(Runs, MeasureBehindTheStart) {
  const Plan one = plan(
      "[campaign]\nfor = \"2s\"\nstart = \"3s\"\n[campaign.vary]\n\"set.MD 20\" = [1.5, 2.5]\n"
      "[campaign.measure]\nx = \"last MD 24\"\nc = \"cycles\"\n");
  const Outcome outcome = run(one, 1);
  EXPECT_EQ(outcome.measures[0], 0x40200000);  // 2.5 in a double word
  EXPECT_NEAR(outcome.seconds, 5, 0.01);
  EXPECT_LT(*outcome.measures[1], static_cast<double>(outcome.cycles));
}

TEST_F(Runs, SetWholeNumbersOf32Bits) {
  const Plan one = plan(
      "[campaign]\nfor = \"1s\"\nrepeat = 1\n[campaign.vary]\n\"set.MD 20\" = [2, -70000]\n"
      "\"set.MW 10\" = {uniform = [6.9, 7.1]}\n"
      "[campaign.measure]\nx = \"last MD 24\"\ny = \"last MW 10\"\n");
  EXPECT_EQ(run(one, 0).measures[0], 2);
  EXPECT_EQ(run(one, 1).measures[0], 4294967296.0 - 70000);
  EXPECT_EQ(run(one, 1).measures[1], 7);
}

TEST_F(Runs, FollowAScenario) {
  write("fill.scn",
        "scenario \"first\"\n  expect A 124.0 = 0\n  wait 1s\nscenario \"second\"\n  wait 1s\n  "
        "expect A 124.0 = 1\n");
  const Plan one = plan(
      "[campaign]\nscenario = \"fill.scn\"\nfor = \"4s\"\n[campaign.vary]\n\"scenario.name\" = "
      "[\"first\", \"second\"]\n"
      "\"set.MW 10\" = [0, 1]\n[campaign.measure]\nlevel = \"last plant Tank.LEVEL\"\n");
  EXPECT_TRUE(run(one, 0).passed);
  EXPECT_TRUE(run(one, 3).passed) << run(one, 3).message;
  EXPECT_NEAR(*run(one, 3).measures[0], 4, 0.01);  // the scenario ends after 1 s, the run after 4 s
  const Outcome failed = run(one, 2);
  EXPECT_FALSE(failed.passed);
  EXPECT_TRUE(failed.message.starts_with("fill.scn:6: at ")) << failed.message;
}

TEST_F(Runs, MoveTheNoiseOfPlantsByTheirSeed) {
  const Plan one = plan(
      "[campaign]\nfor = \"1s\"\nrepeat = 2\n[campaign.measure]\nv = \"last plant Noise.PV\"\n");
  EXPECT_NE(run(one, 0).measures, run(one, 1).measures);
  EXPECT_EQ(run(one, 0).measures, run(one, 0).measures);
}

TEST_F(Runs, SetADrawnValueWithinItsLimits) {
  const Plan one = plan(
      "[campaign]\nfor = \"1s\"\nrepeat = 1\n[campaign.vary]\n\"plant.Tank.start\" = {uniform = "
      "[200, 300]}\n"
      "[campaign.measure]\nv = \"last plant Tank.LEVEL\"\n");
  EXPECT_EQ(run(one, 0).measures[0], 100);
}

TEST_F(Runs, HaveAnIdOfAllThatTheyAre) {
  const std::string before = plan(kSweep).id(plan(kSweep).choice(1));
  EXPECT_EQ(before.size(), 64u);
  EXPECT_NE(before, plan(kSweep).id(plan(kSweep).choice(2)));
  std::string other = kSweep;
  other.replace(other.find("10s"), 3, "11s");
  EXPECT_NE(before, plan(other).id(plan(other).choice(1)));
  write("a.awl", std::string(kProgram) + "// changed\n");
  EXPECT_NE(before, plan(kSweep).id(plan(kSweep).choice(1)));
  write("a.awl", kProgram);
  write("README.md", "nothing of the program");
  EXPECT_EQ(before, plan(kSweep).id(plan(kSweep).choice(1)));
}

TEST_F(Runs, StopWithTheCpu) {
  write("a.awl",
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      L     W#16#FFFF\n      "
        "BTI\nEND_ORGANIZATION_BLOCK\n");
  const Outcome outcome = run(plan("[campaign]\nfor = \"1s\"\n"), 0);
  EXPECT_FALSE(outcome.passed);
  EXPECT_NE(outcome.message.find("STOP"), std::string::npos) << outcome.message;
}

struct Wrong {
  const char* line;
  ProblemCode code;
};

// One message for each, with the line of the file.
TEST_F(Runs, NameWhatTheProjectDoesNotHave) {
  const Wrong kWrong[] = {
      {"[campaign.vary]\n\"Tank.start\" = 1", ProblemCode::P0780},
      {"[campaign.vary]\n\"plant.Tank\" = 1", ProblemCode::P0986},
      {"[campaign.vary]\n\"plant.Oven.start\" = 1", ProblemCode::P0986},
      {"[campaign.vary]\n\"plant.Tank.colour\" = 1", ProblemCode::P0781},
      {"[campaign.vary]\n\"plant.Tank.FILL\" = 1", ProblemCode::P0781},  // wired
      {"[campaign.vary]\n\"plant.Tank.start\" = 101", ProblemCode::P0704},
      {"[campaign.vary]\n\"plant.Tank.start\" = \"much\"", ProblemCode::P0704},
      {"[campaign.vary]\n\"plant.Tank.DRAIN\" = 2", ProblemCode::P0989},
      {"[campaign.vary]\n\"set.Motor\" = 1", ProblemCode::P0317},
      {"[campaign.vary]\n\"set.MW 10\" = 70000", ProblemCode::P0202},
      {"[campaign.vary]\n\"set.MW 10\" = 1.5", ProblemCode::P0955},
      {"[campaign.vary]\n\"set.M 10.0\" = 2", ProblemCode::P0955},
      {"[campaign.vary]\n\"cpu.engine\" = \"fast\"", ProblemCode::P0704},
      {"[campaign.vary]\n\"cpu.model\" = \"315\"", ProblemCode::P0705},
      {"[campaign.vary]\n\"scenario.name\" = \"x\"", ProblemCode::P0744},
      {"[campaign.measure]\na = \"most MW 10\"", ProblemCode::P0783},
      {"[campaign.measure]\na = \"max\"", ProblemCode::P0783},
      {"[campaign.measure]\na = \"count MW 10\"", ProblemCode::P0783},
      {"[campaign.measure]\na = \"cycles MW 10\"", ProblemCode::P0783},
      {"[campaign.measure]\na = \"time MW 10 > much\"", ProblemCode::P0783},
      {"[campaign.measure]\na = \"max plant Tank.PV\"", ProblemCode::P0762}};
  for (const Wrong& wrong : kWrong) {
    (void)tryPlan(std::string("[campaign]\nfor = \"1s\"\n") + wrong.line + "\n");
    const auto& variants = problems_.list();
    ASSERT_EQ(variants.size(), 1u) << wrong.line;
    EXPECT_EQ(variants[0].name(), info(wrong.code).name)
        << wrong.line << ": " << variants[0].message;
  }
}

TEST_F(Runs, NeedTheirFiles) {
  (void)tryPlan("[campaign]\nscenario = \"none.scn\"\n");
  ASSERT_EQ(problems_.size(), 1u);
  EXPECT_EQ(problems_.list()[0].position.line, 2u);
  write("fill.scn", "scenario \"first\"\n  wait 1s\n");
  (void)tryPlan("[campaign]\nscenario = \"fill.scn\"\nscenario_name = \"second\"\n");
  ASSERT_EQ(problems_.size(), 1u);
}

}  // namespace
}  // namespace merker::campaign
