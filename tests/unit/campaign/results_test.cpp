// The file of results: each run once, whole or not at all; only with the columns of its campaign.
#include "campaign/results.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "campaign/table.h"

namespace merker::campaign {
namespace {

namespace fs = std::filesystem;

class ResultsFile : public testing::Test {
 protected:
  ResultsFile() {
    fs::create_directory(folder_);
    definition_.name = "Test";
    definition_.parameters = {{"set.\"Set\"\"point\"", {}, {}, {}}, {"cpu.engine", {}, {}, {}}};
    definition_.measures = {{"rest", "last MW 10", {}, {}}};
  }
  ~ResultsFile() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static Finished row(const std::string& id, double rest) {
    return {id, {0, 3, {valueOf(1.5), {"jit", {}}}}, {true, "", 2.5, 9, {rest}}};
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("merker-campaign-" + std::to_string(getpid()));
  Definition definition_;
};

TEST_F(ResultsFile, KeepsARowOnce) {
  auto results = Results::open(path("a.sqlite"), definition_);
  ASSERT_TRUE(results);
  EXPECT_FALSE(results->add({row("x", 1), row("y", 2)}));
  EXPECT_FALSE(results->add({row("x", 5)}));
  EXPECT_EQ(results->ids().value(), (std::set<std::string>{"x", "y"}));
  EXPECT_EQ(results->find("x").value()->measures, (std::vector<std::optional<double>>{1}));
  EXPECT_EQ(results->find("x").value()->seconds, 2.5);
  EXPECT_FALSE(results->find("z").value());
}

TEST_F(ResultsFile, GoesOnWhereItWasLeft) {
  ASSERT_FALSE(Results::open(path("a.sqlite"), definition_)->add({row("x", 1)}));
  EXPECT_EQ(Results::open(path("a.sqlite"), definition_)->ids().value().size(), 1u);
}

TEST_F(ResultsFile, TakesTheRunsOfOthers) {
  auto a = Results::open(path("a.sqlite"), definition_);
  auto b = Results::open(path("b.sqlite"), definition_);
  ASSERT_FALSE(a->add({row("x", 1)}));
  ASSERT_FALSE(b->add({row("x", 1), row("y", 2), row("strange", 3)}));
  EXPECT_EQ(a->addFrom(path("b.sqlite"), definition_, {"x", "y"}).value(), 1u);
  EXPECT_EQ(a->ids().value(), (std::set<std::string>{"x", "y"}));
  EXPECT_EQ(a->addFrom(path("none.sqlite"), definition_, {}).error().code, ProblemCode::P0784);
}

TEST_F(ResultsFile, RefusesOtherColumns) {
  ASSERT_TRUE(Results::open(path("a.sqlite"), definition_));
  definition_.measures.push_back({"more", "cycles", {}, {}});
  EXPECT_EQ(Results::open(path("a.sqlite"), definition_).error().code, ProblemCode::P0785);
}

TEST_F(ResultsFile, RefusesAnotherFile) {
  std::ofstream(path("a.sqlite")) << std::string(5000, 'x');
  EXPECT_EQ(Results::open(path("a.sqlite"), definition_).error().code, ProblemCode::P0786);
  store::Database(path("b.sqlite")).execute("CREATE TABLE t (x)");
  EXPECT_EQ(Results::open(path("b.sqlite"), definition_).error().code, ProblemCode::P0784);
  EXPECT_EQ(readTable(path("b.sqlite")).error().code, ProblemCode::P0784);
}

TEST_F(ResultsFile, IsReadAgainAsATable) {
  ASSERT_FALSE(Results::open(path("a.sqlite"), definition_)->add({row("x", 1)}));
  ASSERT_TRUE(isDatabase(path("a.sqlite")));
  const auto table = readTable(path("a.sqlite"));
  ASSERT_TRUE(table);
  EXPECT_EQ(table->name, "Test");
  EXPECT_EQ(table->parameters,
            (std::vector<std::string>{"set.\"Set\"\"point\"", "cpu.engine", "seed"}));
  ASSERT_EQ(table->rows.size(), 1u);
  EXPECT_EQ(table->rows[0].parameters, (std::vector<Value>{valueOf(1.5), {"jit", {}}, valueOf(3)}));
  EXPECT_EQ(table->rows[0].measures[0], 1);
}

}  // namespace
}  // namespace merker::campaign
