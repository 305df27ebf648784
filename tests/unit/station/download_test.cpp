// Blocks that come and go while the program runs (S7-CYCLE-05): nothing of the old ones is needed,
// nothing of them stays.
#include <gtest/gtest.h>

#include "cpu/cpu.h"
#include "program.h"

namespace merker::station::test {
namespace {

std::shared_ptr<const block::Program> program(std::string_view awl) {
  return compileAwl(awl, defaultCpuModel());
}

std::shared_ptr<const block::Program> withoutOb1() {
  block::Program blocks = *program(ob(1, "") + ob(35, "L MW 12;"));
  blocks.erase({BlockKind::OB, 1});
  return std::make_shared<const block::Program>(std::move(blocks));
}

class Download : public ::testing::TestWithParam<Engine> {
 protected:
  void begin(Plc& plc) {
    plc->setEngine(GetParam());
    plc.cycles(2);
    ASSERT_EQ(plc->mode(), Mode::Run);
  }
};

// S7-OPEN-39: without OB 1 the CPU does not run.
TEST_P(Download, WithoutOb1LeadsToStop) {
  Plc plc(ob(1, "L MW 10; + 1; T MW 10;"));
  begin(plc);
  EXPECT_EQ(plc->download(withoutOb1()), "");
  plc.run(Duration::milliseconds(100));
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_TRUE(plc->stoppedByFault());
  EXPECT_EQ(plc.lastEvent(), 0x456Du);
  EXPECT_EQ(plc->download(program(ob(1, ""))), "");
  EXPECT_TRUE(plc->warmRestart());
}

TEST_P(Download, WithoutOb1InHaltLeadsToStopAfterTheCycle) {
  Plc plc(ob(1, "L MW 10; + 1; T MW 10;"));
  begin(plc);
  ASSERT_TRUE(plc->halt());
  EXPECT_EQ(plc->download(withoutOb1()), "");
  EXPECT_TRUE(plc->resume());
  plc.run(Duration::milliseconds(100));
  EXPECT_EQ(plc.lastEvent(), 0x456Du);
}

// S7-OBI-10: OB 35 waits behind SFC 41 when it is taken away.
TEST_P(Download, AnObThatWaitsAndIsGoneIsAMissingOb) {
  const std::string waits = ob(1,
                               "CALL SFC 41 (RET_VAL := MW 10); CALL SFC 47 (WT := 30000);"
                               "CALL SFC 47 (WT := 30000); CALL SFC 47 (WT := 30000);"
                               "CALL SFC 47 (WT := 30000);");
  Plc plc(waits + ob(35, "L MW 12; + 1; T MW 12;"));
  plc->setEngine(GetParam());
  plc.start();
  while (plc->now() < Instant{} + Duration::milliseconds(101))
    plc->advanceTo(plc->now() + Duration::milliseconds(1));
  ASSERT_EQ(plc->download(program(waits)), "");
  plc.run(Duration::milliseconds(200));
  EXPECT_EQ(plc->mode(), Mode::Stop);  // without OB 85
  EXPECT_TRUE(plc.hasEvent(0x35A1u));
}

TEST_P(Download, OldCodeIsFreed) {
  const std::string other = "FUNCTION FC 2 : VOID\nBEGIN\nL MW 30;\nEND_FUNCTION\n";
  const auto version = [&](int step) {
    return other + "FUNCTION FC 1 : VOID\nBEGIN\nL MW 20; + " + std::to_string(step) +
           "; T MW 20;\nEND_FUNCTION\n" + ob(1, "CALL FC 1; CALL FC 2;");
  };
  Plc plc(version(1));
  begin(plc);
  const std::size_t bytes = plc->compiledBytes();
  plc.write("MW 20", 0);
  for (int step = 2; step < 12; ++step) {
    EXPECT_EQ(plc->download(program(version(step))), "");
    plc->advanceCycles(1);
    EXPECT_EQ(plc->cpu().code().size(), 3u);
    EXPECT_EQ(plc->compiledBytes(), bytes);
  }
  EXPECT_EQ(plc.read("MW 20"), 2u + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11);
}

INSTANTIATE_TEST_SUITE_P(Engines, Download,
                         ::testing::Values(Engine::Interpreter, Engine::Compiled));

}  // namespace
}  // namespace merker::station::test
