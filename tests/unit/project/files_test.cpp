#include "project/files.h"

#include <gtest/gtest.h>

#include "folder.h"

namespace merker::project {
namespace {

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
