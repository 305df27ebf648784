#include "project/discovery.h"

#include <gtest/gtest.h>

#include "folder.h"

namespace merker::project {
namespace {

// "path (sources) [scenarios]" of each target, with paths inside the folder; "-" behind it without
// self-checks.
std::vector<std::string> found(const Folder& folder, const std::string& name = "") {
  std::vector<std::string> list;
  bool missing = false;
  for (const TestTarget& target :
       findTests(name.empty() ? folder.path() : folder.path() + "/" + name, missing)) {
    std::string text = folder.inside(target.path) + " (";
    for (const std::string& source : target.sources) text += folder.inside(source) + " ";
    text += ") [";
    for (const std::string& scenario : target.scenarios) text += folder.inside(scenario) + " ";
    list.push_back(text + "]" + (target.selfChecks ? "" : "-"));
  }
  return list;
}

using List = std::vector<std::string>;

TEST(Discovery, AProjectWithItsScenarios) {
  const Folder folder;
  for (const char* name : {"p/merker.toml", "p/a.awl", "p/a.scn", "p/tests/b.scn"})
    folder.write(name);
  EXPECT_EQ(found(folder, "p"), (List{"p () [p/a.scn p/tests/b.scn ]"}));
  EXPECT_EQ(found(folder), (List{"p () [p/a.scn p/tests/b.scn ]"}));
  EXPECT_EQ(found(folder, "p/merker.toml"), (List{"p () [p/a.scn p/tests/b.scn ]"}));
}

TEST(Discovery, LooseFiles) {
  const Folder folder;
  for (const char* name :
       {"a.awl", "a.scn", "b.awl", "sub/c.awl", "sub/other.scn", "sub/more.scn", "sub/d.awl"})
    folder.write(name);
  EXPECT_EQ(found(folder),
            (List{"a.awl () [a.scn ]", "b.awl () []", "sub/c.awl () []", "sub/d.awl () []",
                  "sub (sub/c.awl sub/d.awl ) [sub/more.scn sub/other.scn ]-"}));
}

TEST(Discovery, ASingleSource) {
  const Folder folder;
  for (const char* name : {"a.awl", "a.scn", "b.scn"}) folder.write(name);
  EXPECT_EQ(found(folder, "a.awl"), (List{"a.awl () [a.scn ]"}));
}

TEST(Discovery, ASingleScenarioBelongsToItsProjectOrTheSourcesBesideIt) {
  const Folder folder;
  for (const char* name : {"p/merker.toml", "p/tests/b.scn", "q/a.awl", "q/a.scn", "q/b.scn"})
    folder.write(name);
  EXPECT_EQ(found(folder, "p/tests/b.scn"), (List{"p () [p/tests/b.scn ]-"}));
  EXPECT_EQ(found(folder, "q/a.scn"), (List{"q/a.awl () [q/a.scn ]-"}));
  EXPECT_EQ(found(folder, "q/b.scn"), (List{"q (q/a.awl ) [q/b.scn ]-"}));
}

TEST(Discovery, WhatIsMissing) {
  const Folder folder;
  bool missing = false;
  EXPECT_TRUE(findTests(folder.path() + "/none", missing).empty());
  EXPECT_TRUE(missing);
  EXPECT_TRUE(findTests(folder.path(), missing).empty());
  EXPECT_FALSE(missing);
}

}  // namespace
}  // namespace merker::project
