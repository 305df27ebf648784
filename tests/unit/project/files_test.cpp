#include "project/files.h"

#include <gtest/gtest.h>

#include "folder.h"

namespace merker::project {
namespace {

TEST(Files, Patterns) {
  EXPECT_TRUE(matches("*.awl", "main.awl"));
  EXPECT_TRUE(matches("*.awl", "MAIN.AWL"));
  EXPECT_FALSE(matches("*.awl", "lib/main.awl"));
  EXPECT_TRUE(matches("lib/*.awl", "lib/a.awl"));
  EXPECT_TRUE(matches("**/*.awl", "a.awl"));
  EXPECT_TRUE(matches("lib/**/*.awl", "lib/x/y/a.awl"));
  EXPECT_TRUE(matches("lib/**/*.awl", "lib/a.awl"));
  EXPECT_TRUE(matches("fc?.awl", "fc1.awl"));
  EXPECT_FALSE(matches("fc?.awl", "fc/.awl"));
  EXPECT_FALSE(matches("*.awl", "main.awlx"));
  EXPECT_TRUE(matches("main.awl", "main.awl"));
}

// Each star may stand for many things; all ways at once (once a second for each further star).
TEST(Files, ManyStarsTakeNoTime) {
  std::string pattern = "*", folders = "**/";
  for (int i = 0; i < 40; ++i) pattern += "a*", folders += "**/";
  const std::string name(200, 'a');
  EXPECT_FALSE(matches(pattern + "b", name));
  EXPECT_TRUE(matches(pattern, name));
  std::string path;
  for (int i = 0; i < 60; ++i) path += "x/";
  EXPECT_FALSE(matches(folders + "b", path + "a"));
  EXPECT_TRUE(matches(folders + "a", path + "a"));
  EXPECT_TRUE(matches("**/x/**/x/*", path + "a"));
}

TEST(Files, StarsWithinAndBetweenNames) {
  EXPECT_TRUE(matches("a**b", "axxb"));
  EXPECT_FALSE(matches("a**b", "ax/b"));
  EXPECT_TRUE(matches("**/b/**/c", "b/c"));
  EXPECT_FALSE(matches("**/b", "xb"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_FALSE(matches("?", ""));
  EXPECT_FALSE(matches("", "a"));
  EXPECT_TRUE(matches("**/", "a/"));
}

TEST(Files, FoldersTooDeepAreLeftOutAndReported) {
  const Folder folder;
  std::string deep;
  for (std::size_t i = 0; i < kDeepestFolder; ++i) deep += "d/";
  folder.write(deep + "in.awl");
  folder.write(deep + "e/out.awl");
  Problems problems;
  EXPECT_EQ(listFiles(folder.path(), &problems), (std::vector<std::string>{deep + "in.awl"}));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.list()[0].code, ProblemCode::P0715);
}

TEST(Files, SortedWithoutHiddenOnesAndOtherProjects) {
  const Folder folder;
  for (const char* name :
       {"b.awl", "a/z.awl", ".hidden/x.awl", ".x.awl", "other/merker.toml", "other/c.awl"})
    folder.write(name);
  EXPECT_EQ(listFiles(folder.path()), (std::vector<std::string>{"a/z.awl", "b.awl"}));
}

TEST(Files, ALinkBackUpIsNotFollowed) {
  const Folder folder;
  folder.write("a/b.awl");
  std::filesystem::create_directory_symlink(folder.path(), folder.path() + "/a/up");
  EXPECT_EQ(listFiles(folder.path()), (std::vector<std::string>{"a/b.awl"}));
}

TEST(Files, Names) {
  EXPECT_TRUE(hasExtension("a.AWL", ".awl"));
  EXPECT_FALSE(hasExtension(".awl", ".awl"));
  EXPECT_EQ(join(".", "a.awl"), "a.awl");
  EXPECT_EQ(join("x/", "a.awl"), "x/a.awl");
  EXPECT_EQ(folderOf("a.awl"), ".");
  EXPECT_EQ(stemOf("x/a.b.awl"), "a.b");
}

}  // namespace
}  // namespace merker::project
