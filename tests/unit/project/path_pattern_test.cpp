#include "project/path_pattern.h"

#include <gtest/gtest.h>

#include "base/text.h"

namespace merker::project {
namespace {

bool matches(std::string_view pattern, std::string_view path) {
  std::uint64_t steps = 0;
  return PathPattern(pattern).matches(upper(path), steps);
}

std::uint64_t stepsOf(std::string_view pattern, std::string_view path) {
  std::uint64_t steps = 0;
  EXPECT_FALSE(PathPattern(pattern).matches(upper(path), steps));
  return steps;
}

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(PathPattern, NamesAndFolders) {
  EXPECT_TRUE(matches("*.awl", "main.awl"));
  EXPECT_TRUE(matches("*.awl", "MAIN.AWL"));
  EXPECT_FALSE(matches("*.awl", "lib/main.awl"));
  EXPECT_TRUE(matches("lib/*.awl", "lib/a.awl"));
  EXPECT_TRUE(matches("**/*.awl", "a.awl"));
  EXPECT_TRUE(matches("lib/**/*.awl", "lib/x/y/a.awl"));
  EXPECT_TRUE(matches("lib/**/*.awl", "lib/a.awl"));
  EXPECT_FALSE(matches("lib/**/*.awl", "lib/a/b.sym"));
  EXPECT_TRUE(matches("fc?.awl", "fc1.awl"));
  EXPECT_FALSE(matches("fc?.awl", "fc/.awl"));
  EXPECT_FALSE(matches("*.awl", "main.awlx"));
  EXPECT_TRUE(matches("main.awl", "main.awl"));
}

TEST(PathPattern, StarsWithinAndBetweenNames) {
  EXPECT_TRUE(matches("a**b", "axxb"));
  EXPECT_FALSE(matches("a**b", "ax/b"));
  EXPECT_TRUE(matches("**/b/**/c", "b/c"));
  EXPECT_FALSE(matches("**/b", "xb"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_FALSE(matches("?", ""));
  EXPECT_FALSE(matches("", "a"));
  EXPECT_TRUE(matches("**/", "a/"));
}

// What fits too early must be given up for what fits later.
TEST(PathPattern, StarsTakeMoreWhereTheyMust) {
  EXPECT_TRUE(matches("*ab*ab", "abxabxab"));
  EXPECT_TRUE(matches("*aab", "aaaaab"));
  EXPECT_TRUE(matches("*a?b.awl", "aaxab_axb.awl"));
  EXPECT_FALSE(matches("*ab*ab", "xabx"));
  EXPECT_TRUE(matches("**/x/*b/c", "x/ab/d/x/bb/c"));
  EXPECT_TRUE(matches("**/x/**/x/*.awl", "x/a/x/x/y.awl"));
  EXPECT_TRUE(matches("**/a*/b", "a/aa/ab/b"));
  EXPECT_FALSE(matches("**/a*/b", "a/aa/ab/c/b"));
  EXPECT_FALSE(matches("a*/b", "a/x/b"));
}

// Once a second for each further star, then the lengths of pattern and path multiplied.
TEST(PathPattern, ManyStarsTakeFewSteps) {
  const std::string name(200, 'a');
  EXPECT_TRUE(matches(repeated("*a", 40) + "*", name));
  EXPECT_LT(stepsOf(repeated("*a", 120) + "b", name), 1000u);
  EXPECT_LT(stepsOf(repeated("*a?", 80), std::string(100, 'a')), 1000u);
  const std::string path = repeated("x/", 60);
  EXPECT_TRUE(matches(repeated("**/", 40) + "a", path + "a"));
  EXPECT_TRUE(matches("**/x/**/x/*", path + "a"));
  EXPECT_LT(stepsOf(repeated("**/", 40) + "b", path + "a"), 1000u);
}

// The caller adds up what a match costs: the worst is known to him.
TEST(PathPattern, StepsTellWhatItCosts) {
  EXPECT_LT(stepsOf("main.awl", "other.awl"), 5u);
  const std::uint64_t worst = stepsOf("*" + std::string(100, 'a') + "b", std::string(200, 'a'));
  EXPECT_GT(worst, 10'000u);
  EXPECT_LT(worst, 25'000u);
}

}  // namespace
}  // namespace merker::project
