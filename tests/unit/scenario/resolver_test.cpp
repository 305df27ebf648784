#include <gtest/gtest.h>

#include "operands.h"
#include "scenario/scenario.h"

namespace merker::simulator {
namespace {

Problems problemsOf(const char* text) {
  Problems problems;
  const source::SourceFile file("a.scn", text);
  for (Scenario& scenario : parseScenarios(file, problems))
    resolve(scenario, resolveFake, problems);
  return problems;
}

TEST(ScenarioResolver, KnownOperandsAndConstants) {
  EXPECT_TRUE(
      problemsOf("set MW 10 = W#16#FFFF, M 1.0 = TRUE, MB 3 = 255\nexpect MD 4 = MW 10\n").empty());
  EXPECT_TRUE(problemsOf("set dint = -5, real = 5, MD 4 = L#-1\n").empty());
}

TEST(ScenarioResolver, UnknownOperandsWithTheirPlaceAlsoInsideRepeats) {
  const Problems problems = problemsOf("repeat 2\nexpect MW 11 = XY 1\nend\nset nix = 1\n");
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems.list()[0].position, (Position{"a.scn", 2, 8, 5}));
  EXPECT_EQ(problems.list()[1].position, (Position{"a.scn", 2, 16, 4}));
}

TEST(ScenarioResolver, ABadConstantIsNamedAsSuch) {
  const Problems problems = problemsOf("expect MW 10 = W#16#12345\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems.list()[0].code, ProblemCode::P0952);
}

TEST(ScenarioResolver, ValuesMustFit) {
  for (const char* text :
       {"set MB 3 = 256", "set M 1.0 = 2", "set MW 10 = L#70000", "force MB 3 = -1"}) {
    const Problems problems = problemsOf(text);
    ASSERT_EQ(problems.size(), 1u) << text;
    EXPECT_EQ(problems.list()[0].code, ProblemCode::P0955) << text;
  }
}

TEST(ScenarioResolver, DatesAndTextsTakeTheirOwnNotation) {
  EXPECT_TRUE(problemsOf("set string = 'abcde', dt = DT#1994-01-01-00:00:00\n"
                         "expect 'abc' = string\nexpect string = string\n")
                  .empty());
  struct Row {
    const char* text;
    ProblemCode code;
  };
  for (const Row& row :
       {Row{"set string = 5", ProblemCode::P0960},
        Row{"set string = DT#1994-01-01-00:00:00", ProblemCode::P0960},
        Row{"expect dt = 'abc'", ProblemCode::P0960}, Row{"expect dt = TRUE", ProblemCode::P0960},
        Row{"expect dt = string", ProblemCode::P0960},
        Row{"expect MW 10 = string", ProblemCode::P0960},
        Row{"expect string = 'ab", ProblemCode::P0209},
        Row{"set string = 'abcdef'", ProblemCode::P0961},
        Row{"set 5 = MW 10", ProblemCode::P0904}}) {
    const Problems problems = problemsOf(row.text);
    ASSERT_EQ(problems.size(), 1u) << row.text;
    EXPECT_EQ(problems.list()[0].code, row.code) << row.text;
  }
}

}  // namespace
}  // namespace merker::simulator
