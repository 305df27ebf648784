// Compiling goes on beside the PLC: requests that need it are answered when it is done.
#include <deque>

#include "bench.h"

namespace merker::workbench::test {
namespace {

// A worker that works when the test says so.
class Compiling : public ::testing::Test {
 protected:
  Compiling() {
    bench.workbench.compileBy([this](Work work) { works.push_back(std::move(work)); });
  }
  std::string ask(const std::string& method, Json fields = Json::object()) {
    fields["id"] = ++id;
    fields["do"] = method;
    return bench.workbench.handle(1, fields.dump());
  }
  void workOne() {
    const Work work = std::move(works.front());
    works.pop_front();
    work();
  }
  Json later() {
    const auto answers = bench.workbench.laterAnswers();
    EXPECT_EQ(answers.size(), 1u);
    return answers.empty() ? Json(nullptr) : Json::parse(answers[0].second);
  }

  std::deque<Work> works;
  std::uint64_t id = 1000;
  Bench bench;
};

TEST_F(Compiling, ThePlcGoesOnMeanwhile) {
  EXPECT_EQ(ask("program.load"), "");
  ASSERT_EQ(works.size(), 1u);
  const auto before = bench.workbench.plc()->controller().cycles();
  std::int64_t wall = 0;
  for (int i = 0; i < 10; ++i)
    bench.workbench.advance([&] { return wall += 1'000'000; }, Duration::milliseconds(5));
  EXPECT_GT(bench.workbench.plc()->controller().cycles(), before + 10);
  EXPECT_FALSE(ask("files.list").empty());  // what compiles nothing is answered at once
  EXPECT_TRUE(bench.workbench.laterAnswers().empty());
  workOne();
  const Json answer = later();
  EXPECT_EQ(answer["id"], 1001);
  EXPECT_TRUE(answer.contains("result")) << answer;
}

TEST_F(Compiling, OneCompilationDoesForAllWhoAskMeanwhile) {
  EXPECT_EQ(ask("program.blocks"), "");
  EXPECT_EQ(ask("program.completion"), "");
  EXPECT_EQ(ask("program.compare"), "");
  ASSERT_EQ(works.size(), 1u);
  workOne();
  EXPECT_EQ(bench.workbench.laterAnswers().size(), 3u);
  EXPECT_FALSE(ask("program.blocks").empty());  // nothing has changed since
  bench.folder.write("other.awl", "FUNCTION FC 9 : VOID\nBEGIN\nEND_FUNCTION\n");
  EXPECT_EQ(ask("program.blocks"), "");
  workOne();
  EXPECT_EQ(later()["result"]["blocks"].size(), 3u);
}

TEST_F(Compiling, TextsThatAreNotSavedAreChecked) {
  EXPECT_EQ(ask("program.check", {{"files", {{{"path", "main.awl"}, {"text", "nonsense"}}}}}), "");
  workOne();
  EXPECT_FALSE(later()["result"]["problems"].empty());
}

TEST_F(Compiling, AProjectThatWasClosedMeanwhileGetsNothing) {
  EXPECT_EQ(ask("program.load"), "");
  ask("projects.close");
  workOne();
  EXPECT_EQ(later()["problems"][0]["code"], "P1315");
}

TEST_F(Compiling, ABrowserThatHasGoneGetsNothing) {
  EXPECT_EQ(ask("program.check"), "");
  bench.workbench.closed(1);
  workOne();
  EXPECT_TRUE(bench.workbench.laterAnswers().empty());
}

TEST_F(Compiling, WaitsForSoManyOnly) {
  for (int i = 0; i < 64; ++i) EXPECT_EQ(ask("program.check"), "");
  EXPECT_NE(ask("program.check").find("P1314"), std::string::npos);
}

}  // namespace
}  // namespace merker::workbench::test
