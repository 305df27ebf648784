// The CPU is saved in the middle of a cycle, which others do not wait for.
#include "bench.h"
#include "cpu/cpu.h"

namespace merker::workbench::test {
namespace {

// About 100 ms a cycle, which nobody takes for an endless loop.
constexpr const char* kLongCycle = R"(ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     30000;
more: T     MW 100;
      T     MW 102;
      T     MW 104;
      L     MW 100;
      LOOP  more;
      L     MW 20;
      +     1;
      T     MW 20;
END_ORGANIZATION_BLOCK
)";

class LongCycle : public ::testing::Test {
 protected:
  LongCycle() {
    controller::Controller& plc = bench.workbench.plc()->controller();
    plc.advanceTo(plc.now() + Duration::milliseconds(7));
    EXPECT_FALSE(between());
  }
  bool between() { return bench.workbench.plc()->blockCpu()->cpu().betweenCycles(); }
  std::uint32_t counted() {
    Plc& plc = *bench.workbench.plc();
    return plc.controller().read(*plc.operand("MW 20")).value_or(0);
  }
  std::string save() {
    return bench.workbench.handle(1, R"({"id": 7, "do": "cpu.save", "path": "a.state"})");
  }
  // Slices of two looks at the clock until there is an answer.
  Json answer() {
    for (slices = 1; slices < 1000; ++slices) {
      bench.workbench.advance([&] { return wall += 3'000'000; }, Duration::milliseconds(5));
      const auto answers = bench.workbench.laterAnswers();
      if (!answers.empty()) return Json::parse(answers[0].second);
    }
    return nullptr;
  }

  Bench bench{kLongCycle, "[cpu]\ncycle_monitoring = \"6s\"\n"};
  std::int64_t wall = 0;
  int slices = 0;
};

TEST_F(LongCycle, IsWaitedForBetweenOtherRequests) {
  EXPECT_EQ(save(), "");
  EXPECT_TRUE(bench.workbench.busy(1));
  bench.workbench.opened(2);
  const Instant before = bench.workbench.plc()->controller().now();
  bench.call("ping", {}, 2);
  EXPECT_EQ(bench.workbench.plc()->controller().now(), before);
  EXPECT_TRUE(answer().contains("result"));
  EXPECT_GE(slices, 2);
  EXPECT_TRUE(between());
  const std::uint32_t saved = counted();
  bench.run(Duration::seconds(1));
  bench.call("cpu.load", {{"path", "a.state"}});
  EXPECT_EQ(counted(), saved);
}

TEST_F(LongCycle, EndsWhileTimeIsPausedToo) {
  bench.call("time.pace", {{"mode", "pause"}});
  EXPECT_EQ(save(), "");
  EXPECT_TRUE(answer().contains("result"));
  const Instant saved = bench.workbench.plc()->controller().now();
  bench.workbench.advance([&] { return wall += 1'000'000; }, Duration::milliseconds(5));
  EXPECT_EQ(bench.workbench.plc()->controller().now(), saved);
}

TEST_F(LongCycle, IsNotWaitedForWhereTheCpuStopsOrGoes) {
  EXPECT_EQ(save(), "");
  bench.workbench.opened(2);
  bench.call("cpu.stop", {}, 2);
  EXPECT_TRUE(answer().contains("result"));
  EXPECT_EQ(slices, 1);
  bench.call("cpu.load", {{"path", "a.state"}});
  EXPECT_EQ(bench.state()["mode"], "STOP");
  bench.call("cpu.start");
  controller::Controller& plc = bench.workbench.plc()->controller();
  plc.advanceTo(plc.now() + Duration::milliseconds(7));
  EXPECT_EQ(save(), "");
  bench.call("projects.close", {}, 2);
  const auto answers = bench.workbench.laterAnswers();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(Json::parse(answers[0].second)["problems"][0]["code"], "P1308");
}

TEST_F(LongCycle, GoesOnForNobodyWhoHasGone) {
  EXPECT_EQ(save(), "");
  bench.workbench.closed(1);
  EXPECT_EQ(answer(), Json());
  EXPECT_FALSE(std::filesystem::exists(bench.folder.path("a.state")));
}

}  // namespace
}  // namespace merker::workbench::test
