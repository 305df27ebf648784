#include "project/settings.h"

#include <gtest/gtest.h>

namespace merker::project {
namespace {

struct Read {
  Settings settings;
  Problems problems;
  // "2:1 P0703" of the only problem.
  std::string problem() const {
    if (problems.size() != 1) return std::to_string(problems.size()) + " problems";
    const Problem& p = problems.list()[0];
    return std::to_string(p.position.line) + ":" + std::to_string(p.position.column) + " " +
           std::string(p.name());
  }
};

Read read(std::string text) {
  Read result;
  result.settings =
      readSettings(source::SourceFile("merker.toml", std::move(text)), result.problems);
  return result;
}

TEST(Settings, AllKeysAreOptional) {
  const Read r = read("");
  EXPECT_TRUE(r.problems.empty());
  EXPECT_EQ(r.settings.model, &defaultCpuModel());
  EXPECT_FALSE(r.settings.sources.has_value());
  EXPECT_EQ(r.settings.startOfClock,
            1461LL * 24 * 3600 * 1000);  // 1994-01-01: four years, one of them a leap year
}

// S7-MGR-01, S7-NET-03: a new CPU has 2; 0 and 1 belong to others.
TEST(Settings, TheMpiAddress) {
  EXPECT_EQ(read("").settings.mpiAddress, 2u);
  EXPECT_EQ(read("[cpu]\nmpi_address = 126").settings.mpiAddress, 126u);
  EXPECT_EQ(read("[cpu]\nmpi_address = 1").problem(), "2:15 P0704");
  EXPECT_EQ(read("[cpu]\nmpi_address = 127").problem(), "2:15 P0704");
}

TEST(Settings, EveryKey) {
  const Read r = read(R"([project]
name = "Plant"
[program]
sources = ["main.awl", "lib/**/*.awl"]
symbols = []
[cpu]
model = "generic"
clock = "DT#1990-01-02-00:00:01.500"
)");
  EXPECT_TRUE(r.problems.empty());
  EXPECT_EQ(r.settings.name, "Plant");
  ASSERT_EQ(r.settings.sources->size(), 2u);
  EXPECT_EQ((*r.settings.sources)[1].text, "lib/**/*.awl");
  EXPECT_EQ((*r.settings.sources)[1].position.line, 4u);
  EXPECT_TRUE(r.settings.symbols->empty());
  EXPECT_EQ(r.settings.model, findCpuModel("generic"));
  EXPECT_EQ(r.settings.startOfClock, 86'400'000 + 1'500);
}

TEST(Settings, UnknownKeysHaveTheirPlace) {
  EXPECT_EQ(read("[projekt]\n").problem().substr(0, 9), "1:2 P0703");
  EXPECT_EQ(read("[cpu]\n  modell = \"x\"\n").problem(), "2:3 P0703");
  EXPECT_EQ(read("name = 1\n").problem(), "1:1 P0703");
  EXPECT_NE(read("[cpu]\nmodell = \"x\"\n").problems.list()[0].message.find("model, clock"),
            std::string::npos);
}

TEST(Settings, WrongValues) {
  EXPECT_EQ(read("[project]\nname = 5\n").problem(), "2:8 P0704");
  EXPECT_EQ(read("[program]\nsources = \"a.awl\"\n").problem(), "2:11 P0704");
  EXPECT_EQ(read("[program]\nsources = [\"a.awl\", 5]\n").problem(), "2:21 P0704");
  EXPECT_EQ(read("[cpu]\nmodel = \"317\"\n").problem(), "2:9 P0705");
  EXPECT_EQ(read("project = 1\n").problem(), "1:1 P0704");
  EXPECT_EQ(read("[cpu]\nclock = 2005-03-01\n").problem(), "2:9 P0704");
  EXPECT_EQ(read("[cpu]\nclock = \"DT#2005-13-01-00:00:00\"\n").problems.size(), 1u);
}

TEST(Settings, WhatIsNoToml) {
  const Read r = read("[cpu]\nmodel = \n");
  ASSERT_EQ(r.problems.size(), 1u);
  EXPECT_EQ(r.problems.list()[0].code, ProblemCode::P0702);
  EXPECT_EQ(r.problems.list()[0].position.line, 2u);
}

}  // namespace
}  // namespace merker::project
