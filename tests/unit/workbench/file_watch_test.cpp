// What of a folder is newer than what the CPU holds.
#include "workbench/file_watch.h"

#include <gtest/gtest.h>

namespace merker::workbench::test {
namespace {

using Names = std::vector<std::string>;

Listing folderOf(std::initializer_list<const char*> names) {
  Listing files;
  for (const char* name : names) files[name];
  return files;
}

TEST(FileWatch, KnowsWhatIsNotLoadedYet) {
  FileWatch watch;
  EXPECT_TRUE(watch.take(folderOf({"main.awl", "merker.toml", "notes.txt", "run.scn"})));
  EXPECT_EQ(watch.changed(), (Names{"main.awl", "merker.toml"}));
  watch.loaded();
  EXPECT_EQ(watch.changed(), Names{});
  EXPECT_FALSE(watch.take(watch.files()));
  EXPECT_TRUE(watch.take(folderOf({"merker.toml", "new.sym", "run.scn"})));
  EXPECT_EQ(watch.changed(), (Names{"new.sym", "main.awl"}));
}

// A project that was just made: its hardware is there, its program is not.
TEST(FileWatch, OfANewProjectOnlyTheHardwareIsLoaded) {
  FileWatch watch;
  watch.take(folderOf({"main.awl", "merker.toml"}));
  watch.loaded();
  watch.nothingLoaded();
  EXPECT_EQ(watch.changed(), (Names{"main.awl"}));
}

}  // namespace
}  // namespace merker::workbench::test
