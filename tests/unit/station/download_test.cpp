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
    EXPECT_EQ(plc->cpu().loadMemory().code().size(), 3u);
    EXPECT_EQ(plc->compiledBytes(), bytes);
  }
  EXPECT_EQ(plc.read("MW 20"), 2u + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11);
}

// S7-CYCLE-05, S7-MEM-04: a data block keeps its values as long as nothing of it changes: neither
// its start values nor its actual ones nor what kind of block it is.
TEST_P(Download, OnlyChangedDataBlocksAreLoaded) {
  const auto version = [](const std::string& kind, const std::string& start,
                          const std::string& actual, const std::string& code) {
    return "DATA_BLOCK DB 1\n" + kind + "\nSTRUCT\n a : INT := " + start +
           ";\n b : INT;\nEND_STRUCT;\nBEGIN\n b := " + actual + ";\nEND_DATA_BLOCK\n" +
           ob(1, code);
  };
  const auto reloads = [&](const std::string& other) {
    Plc plc(version("", "5", "6", "L MW 10;"));
    begin(plc);
    plc.write("DB1.a", 70);
    plc.write("DB1.b", 80);
    EXPECT_EQ(plc->download(program(other)), "");
    plc->advanceCycles(1);
    const cpu::DataBlock* block = plc->cpu().machine().dataBlocks.find(1);
    return block == nullptr || block->data[1] != 70 || block->data[3] != 80;
  };
  EXPECT_FALSE(reloads(version("", "5", "6", "L MW 10;")));
  EXPECT_FALSE(reloads(version("", "5", "6", "L MW 12;")));
  EXPECT_TRUE(reloads(version("", "4", "6", "L MW 10;")));
  EXPECT_TRUE(reloads(version("", "5", "7", "L MW 10;")));
  EXPECT_TRUE(reloads(version("READ_ONLY", "5", "6", "L MW 10;")));
  EXPECT_TRUE(reloads(version("NON_RETAIN", "5", "6", "L MW 10;")));
}

// S7-MEM-03: an UNLINKED block stays in load memory; one that is gone from the program goes.
TEST_P(Download, DataBlocksComeAndGo) {
  const auto block = [](const std::string& kind) {
    return "DATA_BLOCK DB 2\n" + kind + "\nSTRUCT\n a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  };
  Plc plc(ob(1, ""));
  begin(plc);
  const auto there = [&](const std::string& text) {
    EXPECT_EQ(plc->download(program(text)), "");
    plc->advanceCycles(1);
    return plc->cpu().machine().dataBlocks.find(2) != nullptr;
  };
  EXPECT_TRUE(there(block("") + ob(1, "")));
  EXPECT_FALSE(there(ob(1, "")));
  EXPECT_FALSE(there(block("UNLINKED") + ob(1, "")));
}

// S7-CYCLE-05: a block whose local data grow is another one, though its code is the same.
TEST_P(Download, LocalDataAreThoseOfTheNewBlock) {
  const auto version = [](int bytes) {
    return "FUNCTION FC 1 : VOID\nVAR_TEMP\n x : ARRAY [1.." + std::to_string(bytes) +
           "] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n LAR1 P#L 20.0; L 7; T LW [AR1,P#0.0]; SET; SAVE;"
           "\nEND_FUNCTION\n" +
           ob(1, "CALL FC 1;");
  };
  Plc plc(version(30));
  begin(plc);
  EXPECT_EQ(plc->download(program(version(10))), "");
  plc->advanceCycles(1);
  EXPECT_EQ(plc->mode(), Mode::Stop);  // beyond its local data: 16#2523 without OB 121
  EXPECT_TRUE(plc.hasEvent(0x2523u));
}

INSTANTIATE_TEST_SUITE_P(Engines, Download,
                         ::testing::Values(Engine::Interpreter, Engine::Compiled));

}  // namespace
}  // namespace merker::station::test
