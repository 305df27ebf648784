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

// A file that somebody else has made must not move the cursor of a terminal.
TEST(Problems, showsControlCharacters) {
  const Problem problem = makeProblem(ProblemCode::P0101, {}, "a\x1B[2J\nb\x7F", "\xC2\x9B ä €");
  EXPECT_EQ(problem.message, "cannot read a\\x1B[2J\\x0Ab\\x7F: \\x9B ä €");
}

// Other languages put the same arguments into their own text.
TEST(Problems, keepsItsArguments) {
  const Problem problem = makeProblem(ProblemCode::P0352, {}, 40000, "SPA", -32768, 32767);
  EXPECT_EQ(problem.arguments, (std::vector<std::string>{"40000", "SPA", "-32768", "32767"}));
  EXPECT_EQ(problem.message, "40000 words are too far; SPA can jump -32768..32767");
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

Problems many(std::size_t errors, std::size_t warnings) {
  Problems problems;
  for (std::size_t i = 0; i < warnings; ++i)
    problems.add(ProblemCode::P0104, {"a", static_cast<std::uint32_t>(i)});
  for (std::size_t i = 0; i < errors; ++i)
    problems.add(ProblemCode::P0334, {"b", static_cast<std::uint32_t>(i)}, "XYZ");
  return problems;
}

// Warnings do not push the errors out.
TEST(Problems, keepsTheFirstOfEachSeverityAndCountsTheOthers) {
  Problems problems = many(Problems::kMostKept + 7, Problems::kMostKept + 2);
  EXPECT_EQ(problems.list().size(), 2 * Problems::kMostKept);
  EXPECT_EQ(problems.count(Severity::Error), Problems::kMostKept + 7);
  EXPECT_EQ(problems.size(), 2 * Problems::kMostKept + 9);
  problems.tellRest({"0"});
  problems.tellRest({"0"});  // told once
  problems.sort();
  EXPECT_EQ(problems.list().size(), 2 * Problems::kMostKept + 1);
  EXPECT_EQ(problems.list().back().message, "7 more errors and 2 more warnings are not shown");
  EXPECT_EQ(problems.count(Severity::Warning), Problems::kMostKept + 2);
}

TEST(Problems, fewAreAllKept) {
  Problems problems = many(3, 2);
  problems.tellRest({});
  EXPECT_EQ(problems.list().size(), 5u);
}

TEST(Problems, aListBehindAnotherHasTheSameLimit) {
  Problems problems = many(2, 1), others = many(Problems::kMostKept + 5, 0);
  others.tellRest({});
  problems.append(others);
  problems.tellRest({});
  EXPECT_EQ(problems.count(Severity::Error), Problems::kMostKept + 7);
  EXPECT_EQ(problems.list().size(), Problems::kMostKept + 2);
  EXPECT_EQ(problems.list().back().message, "7 more errors and 0 more warnings are not shown");
}

TEST(Problems, removedOnesDoNotCount) {
  Problems problems = many(3, 2);
  problems.remove(ProblemCode::P0334);
  EXPECT_FALSE(problems.hasErrors());
  EXPECT_EQ(problems.size(), 2u);
}

TEST(Problems, aLongTextIsCutBetweenTwoCharacters) {
  std::string name(kLongestArgument - 1, 'x');
  name += "\u00e4\u00e4";
  const Problem problem = makeProblem(ProblemCode::P0334, {}, name);
  EXPECT_EQ(problem.arguments.front(), std::string(kLongestArgument - 1, 'x') + " \u2026");
}

TEST(Problems, knowWhetherTheirWorkIsCancelled) {
  std::stop_source source;
  const Problems problems(source.get_token()), copy = problems;
  EXPECT_FALSE(copy.cancelled());
  source.request_stop();
  EXPECT_TRUE(copy.cancelled());
  EXPECT_FALSE(Problems().cancelled());
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
