#include "base/problem.h"

#include <gtest/gtest.h>

#include <set>

#include "base/result.h"

namespace merker {
namespace {

TEST(Problems, knowsErrorsFromWarnings) {
  Problems problems;
  problems.add(ProblemCode::P0104, {"a.awl"});
  EXPECT_FALSE(problems.hasErrors());
  problems.add(ProblemCode::P0101, {"a.awl"}, "a.awl", "no such file");
  EXPECT_TRUE(problems.hasErrors());
  EXPECT_EQ(problems.list()[1].message, "cannot read a.awl: no such file");
  EXPECT_EQ(problems.list()[1].name(), "P0101");
}

// Other languages put the same arguments into their own text.
TEST(Problems, keepsItsArguments) {
  const Problem problem = makeProblem(ProblemCode::P0352, {}, 40000, "SPA", -32768, 32767);
  EXPECT_EQ(problem.arguments, (std::vector<std::string>{"40000", "SPA", "-32768", "32767"}));
  EXPECT_EQ(problem.message, "40000 words are too far; SPA takes -32768..32767");
  const Problem twice = makeProblem(ProblemCode::P1107, {}, "E");
  EXPECT_EQ(twice.message, "E needs byte and bit: E 0.0");
}

TEST(Problems, sortedAsAReaderMendsThem) {
  Problems problems;
  const auto add = [&](const char* file, std::uint32_t line, std::uint32_t column) {
    problems.add(ProblemCode::P0104, {file, line, column});
  };
  add("b", 1, 1), add("a", 2, 1), add("a", 1, 9), add("a", 1, 2);
  problems.sort();
  const auto& list = problems.list();
  EXPECT_EQ(list[0].position, (Position{"a", 1, 2}));
  EXPECT_EQ(list[1].position, (Position{"a", 1, 9}));
  EXPECT_EQ(list[2].position, (Position{"a", 2, 1}));
  EXPECT_EQ(list[3].position, (Position{"b", 1, 1}));
}

// Scripts look for the codes, so each exists once.
TEST(Problems, codesAreUnique) {
  const std::string_view names[] = {
#define PROBLEM(code, severity, text) #code,
#include "base/problems.inc"
#undef PROBLEM
  };
  std::set<std::string_view> seen;
  for (const std::string_view name : names) EXPECT_TRUE(seen.insert(name).second) << name;
}

TEST(Result, valueOrError) {
  const Result<int> good = 5;
  const Result<int> bad = makeProblem(ProblemCode::P0104, {});
  EXPECT_TRUE(good.has_value());
  EXPECT_EQ(*good, 5);
  EXPECT_FALSE(bad.has_value());
  EXPECT_EQ(bad.error().name(), "P0104");
}

}  // namespace
}  // namespace merker
