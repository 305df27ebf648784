// The TOML file of a campaign: what it says, and one message for each mistake.
#include "campaign/definition.h"

#include <gtest/gtest.h>

namespace merker::campaign {
namespace {

Definition read(const std::string& text, Problems& problems) {
  return readDefinition(source::SourceFile("a/sweep.toml", text), problems);
}

TEST(Definition, HasWhatTheFileSays) {
  Problems problems;
  const Definition one = read(R"([campaign]
for = "10m"
repeat = 1000
[campaign.vary]
"plant.Vessel.stroke" = {from = 0.8, to = 1.2, steps = 9}
"cpu.engine" = ["interpreter", "jit"]
"plant.Vessel.start" = {normal = 80, sigma = 6}
[campaign.measure]
overflow = "max plant Vessel.LEVEL"
[campaign.require]
overflow = "<= 95.5"
)",
                              problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(one.name, "sweep");
  EXPECT_EQ(one.folder, "a");
  EXPECT_EQ(one.time, Duration::seconds(600));
  EXPECT_EQ(one.runs(), 18'000u);
  ASSERT_EQ(one.parameters.size(), 3u);
  EXPECT_EQ(one.parameters[0].values[1].value.text, "0.85");  // not 0.8500000000000001
  EXPECT_EQ(one.parameters[0].values[8].value.number, 1.2);
  EXPECT_EQ(one.parameters[1].values[1].value, (Value{"jit", {}}));
  EXPECT_EQ(one.parameters[2].draw->b, 6);
  ASSERT_TRUE(one.measures[0].required);
  EXPECT_EQ(one.measures[0].required->relation, block::Relation::LessEqual);
  EXPECT_EQ(one.measures[0].required->value, 95.5);
}

struct Mistake {
  std::string text;
  ProblemCode code;
  std::uint32_t line, column;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

// One message each, at its place.
TEST_P(Mistakes, AreTold) {
  const Mistake& mistake = GetParam();
  Problems problems;
  read(mistake.text, problems);
  ASSERT_EQ(problems.size(), 1u) << mistake.text;
  const Problem& problem = problems.list().front();
  EXPECT_EQ(info(problem.code).name, info(mistake.code).name) << problem.message;
  EXPECT_EQ(problem.position.line, mistake.line) << problem.message;
  EXPECT_EQ(problem.position.column, mistake.column) << problem.message;
}

std::string vary(const std::string& line) {
  return "[campaign]\nfor = \"1s\"\nrepeat = 2\n[campaign.vary]\n" + line + "\n";
}
std::string measure(const std::string& lines) {
  return "[campaign]\nfor = \"1s\"\n[campaign.measure]\n" + lines + "\n";
}
std::string manyRuns() {
  std::string text = "[campaign]\nfor = \"1s\"\nrepeat = 1000000\n[campaign.vary]\n";
  return text + "\"set.MW 10\" = [1, 2]\n";
}
std::string manyParameters() {
  std::string text = vary("");
  for (int i = 0; i < 17; ++i) text += "\"set.MW " + std::to_string(2 * i) + "\" = 1\n";
  return text;
}

INSTANTIATE_TEST_SUITE_P(
    All, Mistakes,
    testing::Values(
        Mistake{"[campaign", ProblemCode::P0702, 1, 10}, Mistake{"", ProblemCode::P0744, 1, 1},
        Mistake{"campaign = 1\n", ProblemCode::P0704, 1, 1},
        Mistake{"[campaign]\nfor = \"1s\"\n[other]\n", ProblemCode::P0703, 3, 2},
        Mistake{"[campaign]\nfor = \"1s\"\nfro = 1\n", ProblemCode::P0703, 3, 1},
        Mistake{"[campaign]\nrepeat = 3\n", ProblemCode::P0744, 1, 2},
        Mistake{"[campaign]\nfor = 10\n", ProblemCode::P0704, 2, 7},
        Mistake{"[campaign]\nfor = \"0s\"\n", ProblemCode::P0704, 2, 7},
        Mistake{"[campaign]\nfor = \"1s\"\nrepeat = 1000001\n", ProblemCode::P0704, 3, 10},
        Mistake{"[campaign]\nfor = \"1s\"\nrepeat = 1e400\n", ProblemCode::P0702, 3, 15},
        Mistake{"[campaign]\nscenario = \"a.scn\"\nstart = \"1s\"\n", ProblemCode::P0744, 3, 9},
        Mistake{"[campaign]\nfor = \"1s\"\nscenario_name = \"a\"\n", ProblemCode::P0744, 3, 17},
        Mistake{"[campaign]\nfor = \"1s\"\ntime_limit = \"1ms\"\n", ProblemCode::P0704, 3, 14},
        Mistake{"[campaign]\nfor = \"1s\"\nmemory_limit = 1\n", ProblemCode::P0704, 3, 16},
        Mistake{vary("\"set.MW 10\" = []"), ProblemCode::P0704, 5, 15},
        Mistake{vary("\"set.MW 10\" = [1, [2]]"), ProblemCode::P0704, 5, 19},
        Mistake{vary("\"set.MW 10\" = [1, 1e16]"), ProblemCode::P0704, 5, 19},
        Mistake{vary("\"set.MW 10\" = nan"), ProblemCode::P0704, 5, 15},
        Mistake{vary("\"set.MW 10\" = {from = 1, to = 2, steps = 1}"), ProblemCode::P0704, 5, 42},
        Mistake{vary("\"set.MW 10\" = {from = 1, to = 2}"), ProblemCode::P0744, 5, 1},
        Mistake{vary("\"set.MW 10\" = {normal = 1}"), ProblemCode::P0744, 5, 1},
        Mistake{vary("\"set.MW 10\" = {uniform = [2, 1]}"), ProblemCode::P0704, 5, 26},
        Mistake{vary("\"set.MW 10\" = {uniform = [1]}"), ProblemCode::P0704, 5, 26},
        Mistake{vary("plant.Vessel.stroke = 1"), ProblemCode::P0704, 5, 1},
        Mistake{vary("\"seed\" = 1"), ProblemCode::P0742, 5, 1},
        Mistake{vary("\"a\\nb\" = 1"), ProblemCode::P0704, 5, 1},
        Mistake{"[campaign]\nfor = \"1s\"\n[campaign.vary]\n\"set.MW 10\" = {uniform = [1, 2]}\n",
                ProblemCode::P0744, 4, 15},
        Mistake{manyRuns(), ProblemCode::P0782, 1, 2},
        Mistake{manyParameters(), ProblemCode::P0704, 4, 11},
        Mistake{measure("two words = 1"), ProblemCode::P0702, 4, 5},
        Mistake{measure("\"two words\" = \"max MW 10\""), ProblemCode::P0704, 4, 1},
        Mistake{measure("a = 1"), ProblemCode::P0704, 4, 5},
        Mistake{measure("Passed = \"cycles\""), ProblemCode::P0742, 4, 1},
        Mistake{measure("a = \"cycles\"\nA = \"cycles\""), ProblemCode::P0742, 5, 1},
        Mistake{measure("a = \"cycles\"\n[campaign.require]\nb = \"< 1\""), ProblemCode::P0703, 6,
                1},
        Mistake{measure("a = \"cycles\"\n[campaign.require]\na = \"1\""), ProblemCode::P0704, 6,
                5}));

}  // namespace
}  // namespace merker::campaign
