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
    work->carryOut();
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
  EXPECT_TRUE(bench.workbench.laterAnswers().empty());
  ASSERT_EQ(works.size(), 1u);  // its blocks are translated
  workOne();
  const Json answer = later();
  EXPECT_EQ(answer["id"], 1001);
  EXPECT_TRUE(answer.contains("result")) << answer;
}

TEST_F(Compiling, BlocksAreTranslatedBesideThePlc) {
  bench.call("cpu.stop");
  EXPECT_EQ(ask("cpu.engine", {{"engine", "jit"}}), "");
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(bench.state()["engine"], "interpreter");
  workOne();
  const Json answer = later();
  if (answer.contains("problems")) GTEST_SKIP() << "no compiler for this processor";
  EXPECT_EQ(bench.state()["engine"], "jit");
  EXPECT_GT(controller::capability<controller::MachineCode>(bench.workbench.plc()->controller())
                ->compiledBytes(),
            0u);
  bench.workbench.compileBy([](const Work& work) { work->carryOut(); });
  bench.call("cpu.start");
  bench.run(Duration::milliseconds(100));
  EXPECT_EQ(bench.state()["mode"], "RUN");
}

TEST_F(Compiling, TheEngineIsRefusedWhereTheCpuHasStartedMeanwhile) {
  bench.call("cpu.stop");
  EXPECT_EQ(ask("cpu.engine", {{"engine", "jit"}}), "");
  bench.call("cpu.start");
  workOne();
  EXPECT_EQ(later()["problems"][0]["code"], "P1308");
  EXPECT_EQ(bench.state()["engine"], "interpreter");
}

TEST_F(Compiling, BlocksAreTranslatedAgainForAnotherProgram) {
  bench.call("cpu.stop");
  EXPECT_EQ(ask("cpu.engine", {{"engine", "jit"}}), "");
  Plc& plc = *bench.workbench.plc();
  EXPECT_EQ(plc.download(std::make_shared<const block::Program>(*plc.program())), "");
  workOne();
  EXPECT_TRUE(bench.workbench.laterAnswers().empty());
  EXPECT_EQ(bench.state()["engine"], "interpreter");
  ASSERT_EQ(works.size(), 1u);
  workOne();
  EXPECT_EQ(bench.workbench.laterAnswers().size(), 1u);
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

TEST_F(Compiling, WhatCameToNothingIsBegunAgain) {
  EXPECT_EQ(ask("program.blocks"), "");
  works.front()->cancel();
  workOne();
  EXPECT_EQ(later()["problems"][0]["code"], "P1308");
  EXPECT_EQ(ask("program.blocks"), "");
  ASSERT_EQ(works.size(), 1u);
  workOne();
  EXPECT_EQ(later()["result"]["blocks"].size(), 2u);
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

// A check of texts that are typed makes the one before useless; one of the files does not.
TEST_F(Compiling, ANewerCheckTakesThePlaceOfAnOlderOne) {
  const Json typed = {{"files", {{{"path", "main.awl"}, {"text", "nonsense"}}}}};
  EXPECT_EQ(ask("program.check", typed), "");
  EXPECT_EQ(ask("program.check"), "");
  EXPECT_EQ(ask("program.check", typed), "");
  const Json old = later();
  EXPECT_EQ(old["id"], 1001);
  EXPECT_EQ(old["problems"][0]["code"], "P1308");
  ASSERT_EQ(works.size(), 3u);
  EXPECT_TRUE(works[0]->cancelled());
  workOne(), workOne(), workOne();
  const auto answers = bench.workbench.laterAnswers();
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_TRUE(Json::parse(answers[0].second)["result"]["problems"].empty());
  EXPECT_FALSE(Json::parse(answers[1].second)["result"]["problems"].empty());
}

// What nobody waits for any more is asked to end; what others wait for as well is not.
TEST_F(Compiling, ABrowserThatHasGoneStopsItsWork) {
  EXPECT_EQ(ask("program.check"), "");
  EXPECT_EQ(ask("program.blocks"), "");
  bench.workbench.opened(2);
  EXPECT_EQ(bench.workbench.handle(2, R"({"id": 1, "do": "program.completion"})"), "");
  ASSERT_EQ(works.size(), 2u);
  bench.workbench.closed(1);
  EXPECT_TRUE(works[0]->cancelled());
  EXPECT_FALSE(works[1]->cancelled());
  bench.workbench.closed(2);
  EXPECT_TRUE(works[1]->cancelled());
}

// Four megabytes of requests that wait for a compilation are enough: the next one waits unread.
TEST_F(Compiling, HoldsOnlySoManyBytesOfABrowser) {
  const Json row = {{"symbol", "a"}, {"operand", "M 0.0"}, {"comment", std::string(3 << 20, 'x')}};
  const Json big = {{"format", "asc"}, {"rows", Json::array({row})}};
  EXPECT_EQ(ask("symbols.export", big), "");
  EXPECT_FALSE(bench.workbench.busy(1));
  EXPECT_EQ(ask("symbols.export", big), "");
  EXPECT_TRUE(bench.workbench.busy(1));
  EXPECT_FALSE(bench.workbench.busy(2));
  workOne();
  EXPECT_EQ(bench.workbench.laterAnswers().size(), 2u);
  EXPECT_FALSE(bench.workbench.busy(1));
}

// What takes longer than a slice is done elsewhere, and the next request of the same browser waits
// for it: answers come in the order of the requests.
TEST_F(Compiling, AnotherThreadReadsAndWritesFiles) {
  std::deque<Work> clerk;
  bench.workbench.helpBy([&](Work work) { clerk.push_back(std::move(work)); });
  for (const char* method :
       {"files.list", "projects.list", "symbols.check", "symbols.import", "files.read",
        "files.write", "record.stop", "play.start", "cpu.load", "program.delete"}) {
    if (std::string(method) == "record.stop") bench.call("record.start");
    const bool named = findMethodRow(method)->fields.field("path") != nullptr;
    EXPECT_EQ(ask(method, named ? Json{{"path", "a.rec"}} : Json::object()), "") << method;
    EXPECT_TRUE(bench.workbench.busy(1)) << method;
    ASSERT_FALSE(clerk.empty()) << method;
    while (!clerk.empty()) {
      const Work work = std::move(clerk.front());
      clerk.pop_front();
      work->carryOut();
    }
    EXPECT_EQ(bench.workbench.laterAnswers().size(), 1u) << method;
    EXPECT_FALSE(bench.workbench.busy(1)) << method;
  }
}

TEST_F(Compiling, WaitsForSoManyOnly) {
  for (int i = 0; i < 64; ++i) EXPECT_EQ(ask("program.check"), "");
  EXPECT_NE(ask("program.check").find("P1314"), std::string::npos);
}

}  // namespace
}  // namespace merker::workbench::test
