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
