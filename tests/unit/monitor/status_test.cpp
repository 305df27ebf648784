#include <gtest/gtest.h>

#include "plc.h"

namespace merker::monitor::test {
namespace {

std::string ob1(const std::string& code) {
  return "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + code + "END_ORGANIZATION_BLOCK\n";
}

std::string rlo(const ProgramStatus& status) {
  std::string text;
  for (const StatusRow& row : status.rows()) text += !row.reached ? '-' : row.after.rlo ? '1' : '0';
  return text;
}

// S7-EDIT-21, S7-STW-03: the example of 10.7; E 0.0 = 0, E 0.1 = 1.
TEST(Status, ShowsTheResultAfterEachLine) {
  Plc plc(ob1(" U E 0.0;\n O E 0.1;\n U E 0.1;\n = A 1.0;\n"));
  EXPECT_TRUE(plc.debugger().showStatus({BlockKind::OB, 1}));
  EXPECT_EQ(name(plc->write("E 0.1", "1")), "good");
  plc.start();
  plc.station().advanceCycles(2);
  const ProgramStatus& status = *plc.debugger().status();
  EXPECT_EQ(rlo(status), "0111");
  EXPECT_EQ(status.rows()[0].after.sta, false);
  EXPECT_EQ(status.rows()[1].after.sta, true);
  EXPECT_EQ(status.rows()[0].statement.line, 4u);
}

// S7-EDIT-21: accumulators, address registers, data block registers.
TEST(Status, ShowsRegisters) {
  Plc plc("DATA_BLOCK DB 7\nSTRUCT\n a : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n" +
          ob1(" L 17;\n L 4;\n +I;\n LAR1 P#10.3;\n AUF DB 7;\n"));
  plc.debugger().showStatus({BlockKind::OB, 1});
  plc.start();
  plc.station().advanceCycles(1);
  const auto rows = plc.debugger().status()->rows();
  ASSERT_GE(rows.size(), 5u);
  EXPECT_EQ(rows[0].after.accu[0], 17u);
  EXPECT_EQ(rows[1].after.accu[0], 4u);
  EXPECT_EQ(rows[1].after.accu[1], 17u);
  EXPECT_EQ(rows[2].after.accu[0], 21u);
  EXPECT_EQ(rows[2].after.ar1, 0u);
  EXPECT_EQ(rows[3].after.ar1, 83u);
  EXPECT_EQ(rows[3].after.db, 0);
  EXPECT_EQ(rows[4].after.db, 7);
}

// Lines that the last call did not reach show nothing; loops show their last pass.
TEST(Status, ShowsTheLastCallOnly) {
  Plc plc(ob1(" U E 0.0;\n SPB far;\n L 1;\nfar: L 3;\nloop: T MB 0;\n LOOP loop;\n NOP 0;\n"));
  plc.debugger().showStatus({BlockKind::OB, 1});
  plc.start();
  plc.station().advanceCycles(1);
  EXPECT_EQ(rlo(*plc.debugger().status()), "0111111");
  EXPECT_EQ(name(plc->write("E 0.0", "1")), "good");
  plc.station().advanceCycles(1);
  const auto rows = plc.debugger().status()->rows();
  EXPECT_FALSE(rows[2].reached);
  EXPECT_EQ(rows[4].passes, 3u);
  EXPECT_EQ(rows[4].after.accu[0], 1u);
  EXPECT_EQ(plc.debugger().status()->calls(), 2u);
}

// A call shows what it left behind, not what the called block began with.
TEST(Status, LooksAfterACallHasReturned) {
  Plc plc(kProgram);
  plc.debugger().showStatus({BlockKind::OB, 1});
  EXPECT_EQ(name(plc->write("MW 10", "30")), "good");
  plc.start();
  EXPECT_EQ(name(plc->write("MW 10", "30")), "good");
  plc.station().advanceCycles(2);
  const StatusRow* row = plc.debugger().status()->at(plc.place("23").offset);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->after.accu[0], 35u);
}

// S7-EDIT-21: the call environment chooses one of several calls.
TEST(Status, WithCallEnvironment) {
  const std::string text =
      "DATA_BLOCK DB 1\nSTRUCT\n a : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 2\nSTRUCT\n a : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n L DBW 0;\nEND_FUNCTION\n"
      "FUNCTION FC 2 : VOID\nBEGIN\nNETWORK\n AUF DB 2;\n UC FC 1;\nEND_FUNCTION\n" +
      ob1(" L 11;\n AUF DB 1;\n T DBW 0;\n L 22;\n AUF DB 2;\n T DBW 0;\n UC FC 2;\n AUF DB 1;\n"
          " UC FC 1;\n");
  for (const auto& [environment, expected] :
       {std::pair{CallEnvironment{}, 11u},
        {CallEnvironment{.caller = BlockId{BlockKind::FC, 2}}, 22u},
        {CallEnvironment{.db = 2}, 22u},
        {CallEnvironment{.db = 1}, 11u}}) {
    Plc plc(text);
    EXPECT_TRUE(plc.debugger().showStatus({BlockKind::FC, 1}, environment));
    plc.start();
    plc.station().advanceCycles(1);
    const StatusRow* row = plc.debugger().status()->at(0);
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->after.accu[0], expected);
  }
}

// S7-EDIT-21: of a function block that is called with several instance data blocks one is chosen.
TEST(Status, TwoLookAtDifferentInstances) {
  const std::string text =
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n a : INT;\nEND_VAR\nBEGIN\nNETWORK\n L #a;\n"
      "END_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 11 FB 1\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 12 FB 1\nBEGIN\nEND_DATA_BLOCK\n" +
      ob1(" CALL FB 1, DB 11 (a := 5);\n CALL FB 1, DB 12 (a := 7);\n");
  Plc plc(text);
  const BlockId fb{BlockKind::FB, 1};
  const CallEnvironment first{.caller = {}, .db = {}, .di = 11};
  plc.debugger().addStatus(fb);
  plc.debugger().addStatus(fb, first);
  plc.start();
  plc.station().advanceCycles(1);
  const ProgramStatus& all = *plc.debugger().status(fb);
  EXPECT_EQ(all.at(0)->after.accu[0], 7u);
  EXPECT_EQ(all.instance(), 12);
  const ProgramStatus& chosen = *plc.debugger().status(fb, first);
  EXPECT_EQ(chosen.at(0)->after.accu[0], 5u);
  EXPECT_EQ(chosen.instance(), 11);
  EXPECT_EQ(chosen.instances(), (std::set<std::uint16_t>{11, 12}));
}

TEST(Status, WorksTogetherWithBreakpoints) {
  Plc plc(kProgram);
  plc.debugger().showStatus({BlockKind::FC, 1});
  plc.breakAt("FC 1:12");
  plc.start();
  plc.run();
  EXPECT_EQ(rlo(*plc.debugger().status()).substr(2), "---");
  plc.debugger().removeBreakpoints();
  plc.run();
  EXPECT_EQ(plc.debugger().status()->rows()[2].passes, 1u);
  EXPECT_FALSE(plc.debugger().showStatus({BlockKind::FC, 9}));
  plc.debugger().hideStatus();
  EXPECT_EQ(plc.debugger().status(), nullptr);
}

// S7-EDIT-21, S7-INSTR-108: the last statement shows its own result, not what BE makes of it.
TEST(Status, OfTheLastStatementIsItsOwn) {
  Plc plc("FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n L 32767;\n L 1;\n +I;\nEND_FUNCTION\n" +
          ob1(" UC FC 1;\n U M 0.0;\n = A 0.0;\n"));
  plc.debugger().showStatus({BlockKind::FC, 1});
  plc.start();
  plc.station().advanceCycles(1);
  EXPECT_EQ(plc.debugger().status()->rows()[2].after.word & 0xFE, 0x74);  // A0 OV OS STA
  plc.debugger().showStatus({BlockKind::OB, 1});
  plc.station().advanceCycles(1);
  EXPECT_FALSE(plc.debugger().status()->rows()[2].after.sta);
}

// S7-EDIT-21: a statement that ends the block shows what it found.
TEST(Status, OfTheEndOfABlock) {
  Plc plc("FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n U M 0.0;\n BEB;\n L 1;\n BEA;\nEND_FUNCTION\n" +
          ob1(" UC FC 1;\n NOP 0;\n"));
  plc.debugger().showStatus({BlockKind::FC, 1});
  plc.start();
  EXPECT_EQ(name(plc->write("M 0.0", "1")), "good");
  plc.station().advanceCycles(1);
  EXPECT_EQ(rlo(*plc.debugger().status()), "11--");
  EXPECT_EQ(name(plc->write("M 0.0", "0")), "good");
  plc.station().advanceCycles(1);
  EXPECT_EQ(rlo(*plc.debugger().status()).size(), 4u);
  EXPECT_TRUE(plc.debugger().status()->rows()[3].reached);
}

}  // namespace
}  // namespace merker::monitor::test
