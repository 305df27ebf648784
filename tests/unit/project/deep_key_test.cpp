#include "project/deep_key.h"

#include <gtest/gtest.h>

#include <string>

#include "project/settings.h"

namespace merker::project {
namespace {

std::string key(std::size_t parts, const std::string& one = "a") {
  std::string text = one;
  for (std::size_t i = 1; i < parts; ++i) text += "." + one;
  return text;
}

TEST(DeepKey, InHeadersKeysAndQuotationMarks) {
  EXPECT_FALSE(deepKey("[" + key(kDeepestKey) + "]\n" + key(kDeepestKey) + " = 1\n"));
  EXPECT_EQ(deepKey("x = 1\n[" + key(kDeepestKey + 1) + "]\n"), 7u);
  EXPECT_TRUE(deepKey(key(kDeepestKey + 1, " a ") + " = 1\n"));
  EXPECT_TRUE(deepKey(key(kDeepestKey + 1, "\"a\"") + " = 1\n"));
  EXPECT_TRUE(deepKey("x = { " + key(kDeepestKey + 1) + " = 1 }\n"));
}

TEST(DeepKey, PointsOfTextsCommentsAndNumbersAreNone) {
  const std::string points(100, '.');
  EXPECT_FALSE(deepKey("# " + points + "\nx = \"" + points + "\"\n"));
  EXPECT_FALSE(deepKey("x = '" + points + "'\ny = '''" + points + "\n" + points + "'''\n"));
  EXPECT_FALSE(deepKey("x = \"\\\"" + points + "\"\n"));
  EXPECT_TRUE(deepKey("x = \"\"\n" + key(100)));
  std::string numbers = "x = [1.5";
  for (int i = 0; i < 100; ++i) numbers += ", 1.5";
  EXPECT_FALSE(deepKey(numbers + "]\n"));
}

// Once the stack was full.
TEST(DeepKey, IsAProblemOfItsFile) {
  Problems problems;
  const source::SourceFile file("merker.toml", "[" + key(500'000) + "]\n");
  (void)readSettings(file, problems, std::nullopt);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.list()[0].code, ProblemCode::P0202);
  EXPECT_EQ(problems.list()[0].position.line, 1u);
}

TEST(DeepKey, AFileOfMoreThanAMegabyte) {
  Problems problems;
  const source::SourceFile file("merker.toml", std::string(1024 * 1024 + 1, '#'));
  (void)readSettings(file, problems, std::nullopt);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.list()[0].code, ProblemCode::P0103);
}

}  // namespace
}  // namespace merker::project
