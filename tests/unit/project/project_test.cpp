#include "project/project.h"

#include <gtest/gtest.h>

#include "folder.h"

namespace merker::project {
namespace {

std::vector<std::string> names(const Project& project, const Folder& folder) {
  std::vector<std::string> list;
  for (const auto& file : project.sources) list.push_back(folder.inside(file.name()));
  return list;
}

using List = std::vector<std::string>;

TEST(Project, AFolderWithAllItsSourcesAndSymbols) {
  const Folder folder;
  folder.write("merker.toml", "[project]\nname = \"Plant\"\n");
  folder.write("b.awl", "// b\n");
  folder.write("lib/a.awl", "// a\n");
  folder.write("plant.sym", "\"Motor\" A 1.0 BOOL // main drive\n");
  const Project project = load(folder.path(), "");
  EXPECT_TRUE(project.problems.empty()) << project.problems.list()[0].message;
  EXPECT_EQ(project.name, "Plant");
  EXPECT_EQ(names(project, folder), (List{"b.awl", "lib/a.awl"}));
  EXPECT_NE(project.symbols.find("Motor"), nullptr);
  EXPECT_NE(project.file(folder.path() + "/plant.sym"), nullptr);
  EXPECT_FALSE(project.unreadable);
}

TEST(Project, PatternsChooseAndOrder) {
  const Folder folder;
  folder.write("merker.toml",
               "[program]\nsources = [\"z.awl\", \"*.awl\", \"none.awl\"]\nsymbols = []\n");
  folder.write("a.awl");
  folder.write("z.awl");
  folder.write("x.sym", "\"Motor\" A 1.0 BOOL\n");
  const Project project = load(folder.path(), "");
  EXPECT_EQ(names(project, folder), (List{"z.awl", "a.awl"}));
  EXPECT_EQ(project.symbols.find("Motor"), nullptr);
  ASSERT_EQ(project.problems.size(), 1u);
  EXPECT_EQ(project.problems.list()[0].code, ProblemCode::P0706);
  EXPECT_EQ(project.problems.list()[0].position.line, 2u);
}

TEST(Project, PatternsHaveLimits) {
  const Folder folder;
  folder.write("a.awl");
  std::string list;
  for (int i = 0; i < 101; ++i) list += "'*', ";
  for (const auto& [sources, code] :
       {std::pair(list, ProblemCode::P0717),
        std::pair("'" + std::string(261, '*') + "'", ProblemCode::P0716)}) {
    folder.write("merker.toml", "[program]\nsources = [" + sources + "]\n");
    const Project project = load(folder.path(), "");
    ASSERT_FALSE(project.problems.empty());
    EXPECT_EQ(project.problems.list()[0].code, code);
    EXPECT_EQ(project.problems.list()[0].position.line, 2u);
  }
}

// Patterns that cost much, with many files.
TEST(Project, ComparisonsWithPatternsHaveALimit) {
  const Folder folder;
  for (int i = 0; i < 60; ++i) folder.write(std::string(200, 'a') + std::to_string(i) + ".awl");
  std::string list = "'*0.awl',\n";
  for (int i = 0; i < 99; ++i) list += "'*" + std::string(100, 'a') + "b',\n";
  folder.write("merker.toml", "[program]\nsources = [" + list + "]\n");
  const Project project = load(folder.path(), "");
  EXPECT_EQ(project.sources.size(), 6u);  // of the first
  ASSERT_FALSE(project.problems.empty());
  const Problem& last = project.problems.list().back();
  EXPECT_EQ(last.code, ProblemCode::P0106);
  EXPECT_GT(last.position.line, 20u);
  EXPECT_LT(last.position.line, 100u);
}

TEST(Project, ASingleSourceTakesTheSymbolsOfItsName) {
  const Folder folder;
  folder.write("a.awl");
  folder.write("a.sym", "\"Motor\" A 1.0 BOOL\n");
  folder.write("b.sym", "\"Valve\" A 1.1 BOOL\n");
  const Project project = load(folder.path() + "/a.awl", "generic");
  EXPECT_TRUE(project.problems.empty());
  EXPECT_NE(project.symbols.find("Motor"), nullptr);
  EXPECT_EQ(project.symbols.find("Valve"), nullptr);
  EXPECT_EQ(project.model, findCpuModel("generic"));
  EXPECT_EQ(project.name, "a");
}

ProblemCode onlyProblem(const Project& project) {
  EXPECT_EQ(project.problems.size(), 1u);
  return project.problems.empty() ? ProblemCode::P0104 : project.problems.list()[0].code;
}

TEST(Project, WhatCannotBeRead) {
  const Folder folder;
  EXPECT_EQ(onlyProblem(load(folder.path() + "/none.awl", "")), ProblemCode::P0101);
  EXPECT_TRUE(load(folder.path() + "/none.awl", "").unreadable);
  EXPECT_EQ(onlyProblem(load(folder.path(), "")), ProblemCode::P0701);
  EXPECT_TRUE(load(folder.path(), "").unreadable);
  EXPECT_EQ(onlyProblem(load(folder.write("x.exe"), "")), ProblemCode::P0709);
}

TEST(Project, OtherProblems) {
  const Folder folder;
  EXPECT_EQ(onlyProblem(load(folder.write("old.s5"), "314C-2 PtP")), ProblemCode::P0707);
  EXPECT_TRUE(load(folder.write("old.s5"), "").control.has_value());
  EXPECT_EQ(onlyProblem(load(folder.write("a.awl"), "S7-9000")), ProblemCode::P0705);
  EXPECT_EQ(onlyProblem(load(folder.write("b.awl", std::string("\0\1\2\3", 4)), "")),
            ProblemCode::P0102);
  const Folder empty;
  empty.write("merker.toml");
  EXPECT_EQ(onlyProblem(load(empty.path(), "")), ProblemCode::P0708);
}

}  // namespace
}  // namespace merker::project
