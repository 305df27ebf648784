#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "monitor/data_rows.h"
#include "monitor/diagnostic_list.h"
#include "plc.h"

namespace merker::monitor::test {
namespace {

const char* const kNested =
    "DATA_BLOCK DB 3\nSTRUCT\n a : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
    "FUNCTION FC 2 : VOID\n"
    "VAR_TEMP\n mark : WORD;\nEND_VAR\n"
    "BEGIN\nNETWORK\n"
    " L W#16#ABCD;\n T #mark;\n U( ;\n SET;\n AUF DB 99;\n );\n"
    "END_FUNCTION\n"
    "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n AUF DB 3;\n UC FC 2;\nEND_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n UC FC 1;\n NOP 0;\nEND_ORGANIZATION_BLOCK\n";

// S7-DIAG-04: call path, registers, status word and local data at the fault.
TEST(Stacks, AtStopThroughAFault) {
  Plc plc(kNested);
  plc.start();
  plc.station().advanceCycles(1);
  ASSERT_EQ(plc.station().mode(), station::Mode::Stop);
  const Stacks stacks = plc->stacks();
  ASSERT_EQ(stacks.blocks.size(), 3u);
  EXPECT_EQ(toString(stacks.blocks[0].place.block), "FC 2");
  EXPECT_EQ(stacks.blocks[0].place.line, 17u);  // AUF DB 99
  EXPECT_EQ(toString(stacks.blocks[1].place.block), "FC 1");
  EXPECT_EQ(stacks.blocks[1].db, 3);
  EXPECT_EQ(toString(stacks.blocks[2].place.block), "OB 1");
  EXPECT_TRUE(stacks.blocks[2].organizationBlock);
  ASSERT_EQ(stacks.interrupts.size(), 1u);
  EXPECT_EQ(stacks.interrupts[0].ob, 1);
  EXPECT_EQ(stacks.interrupts[0].registers.accu[0], 0xABCDu);
  EXPECT_TRUE(stacks.interrupts[0].registers.rlo);
  EXPECT_EQ(stacks.interrupts[0].brackets.size(), 1u);
  ASSERT_EQ(stacks.locals.size(), 3u);
  EXPECT_EQ(stacks.locals[0].bytes[0], 0xAB);
  EXPECT_EQ(stacks.locals[0].bytes[1], 0xCD);
  const auto names =
      localValues(plc.station().program().at(stacks.locals[0].block), stacks.locals[0].bytes);
  ASSERT_EQ(names.values.size(), 1u);
  EXPECT_EQ(names.values[0].path, "mark");
  EXPECT_EQ(names.values[0].actual, "W#16#ABCD");
}

// A block that is loaded with other code after the STOP has other lines: its address stays, no line
// is named. Other text alone is no other code.
TEST(StopReason, NamesNoLineOfABlockThatIsLoadedAnew) {
  const auto anew = [](const std::string& by) {
    std::string source = kNested;
    const std::string text = " L W#16#ABCD;";
    return source.replace(source.find(text), text.size(), by + text);
  };
  const auto seen = [](Plc& plc, const std::string& words) {
    const auto lines = diagnosticList(plc.station());
    const auto named = [&](const DiagnosticLine& line) {
      return line.place && line.place->line != 0 && toString(line.place->block) == "FC 2";
    };
    const auto told = [&](const auto& entry) {
      return entry.text.find(words) != std::string::npos;
    };
    return std::array{plc.station().stopReason().find(words) != std::string::npos,
                      std::ranges::any_of(lines, named),
                      std::ranges::any_of(plc.station().diagnostics(), told)};
  };
  Plc plc(kNested);
  plc.start();
  plc.station().advanceCycles(1);
  const std::array<bool, 3> all{true, true, true}, none{};
  EXPECT_EQ(seen(plc, "plant.awl:17"), all);
  const Plc commented(anew("// more\n"));
  plc.station().download(std::make_shared<const block::Program>(commented.program()));
  EXPECT_EQ(seen(plc, "plant.awl:18"), all);
  const Plc mended(anew(" NOP 0;\n"));
  plc.station().download(std::make_shared<const block::Program>(mended.program()));
  EXPECT_EQ(seen(plc, "plant.awl"), none);
  EXPECT_NE(plc.station().stopReason().find("FC 2 byte"), std::string::npos);
}

// S7-DIAG-04: while the program runs there is nothing to read; a restart clears them.
TEST(Stacks, OnlyInStopAndHalt) {
  Plc plc(kProgram);
  plc.start();
  plc.station().advanceCycles(1);
  EXPECT_TRUE(plc->stacks().empty());
  plc.breakAt("FC 1:12");
  plc.run();
  EXPECT_EQ(plc->stacks().blocks.size(), 2u);
  EXPECT_EQ(plc->stacks().blocks[0].place.line, 12u);
  plc.debugger().removeBreakpoints();
  plc.run();
  EXPECT_TRUE(plc->stacks().empty());
}

// S7-DIAG-04: the I stack holds the registers of each class that was interrupted.
TEST(Stacks, OfSeveralPriorityClasses) {
  Plc plc(
      "ORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\n L 35;\n AUF DB 99;\nEND_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nhere: L 11;\n SPA here;\n"
      "END_ORGANIZATION_BLOCK\n");
  plc.start();
  plc.run();
  ASSERT_EQ(plc.station().mode(), station::Mode::Stop);
  const Stacks stacks = plc->stacks();
  ASSERT_EQ(stacks.interrupts.size(), 2u);
  EXPECT_EQ(stacks.interrupts[0].ob, 35);
  EXPECT_EQ(stacks.interrupts[0].registers.accu[0], 35u);
  EXPECT_EQ(stacks.interrupts[1].ob, 1);
  EXPECT_EQ(stacks.interrupts[1].registers.accu[0], 11u);
  EXPECT_GT(stacks.interrupts[0].priority, stacks.interrupts[1].priority);
}

// The declared variables of the running block and of its caller.
TEST(FrameVariables, OfFunctionAndFunctionBlock) {
  Plc plc(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n speed : INT := 7;\nEND_VAR\nVAR\n"
      " list : ARRAY [1..2] OF INT := 3, 4;\n pair : STRUCT\n  on : BOOL := TRUE;\n END_STRUCT;\n"
      "END_VAR\nVAR_TEMP\n t : REAL;\nEND_VAR\nBEGIN\nNETWORK\n L 1.5;\n T #t;\n NOP 0;\n"
      "END_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 5 FB 1\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FB 1, DB 5 (speed := 9);\n"
      "END_ORGANIZATION_BLOCK\n");
  plc.debugger().setBreakpoint(plc.place("FB 1:18"));
  plc.start();
  plc.run();
  std::string text;
  for (const FrameVariable& one : plc->variables(0))
    text += one.name + "=" + one.value.value_or("-") + " ";
  EXPECT_EQ(text, "speed=9 list[1]=3 list[2]=4 pair.on=TRUE t=1.500000e+000 ");
  EXPECT_TRUE(plc->variables(7).empty());
}

TEST(FrameVariables, FollowParametersOfAnFc) {
  Plc plc(kProgram);
  plc.breakAt("FC 1:15");
  plc.start();
  EXPECT_EQ(name(plc->write("MW 10", "30")), "good");
  plc.run();
  const auto variables = plc->variables(0);
  ASSERT_EQ(variables.size(), 2u);
  EXPECT_EQ(variables[0].section, "IN");
  EXPECT_EQ(variables[0].value, "30");
  EXPECT_EQ(variables[1].name, "sum");
  EXPECT_EQ(variables[1].value, "35");
}

// S7-PAR-10, S7-PAR-03: members of multiple instances, composite IN_OUT parameters, local data of
// the caller; from outside they are the operands they lie in.
TEST(FrameVariables, AreOperands) {
  Plc plc(
      "FUNCTION_BLOCK FB 1\nVAR_IN_OUT\n pair : ARRAY [1..2] OF INT;\nEND_VAR\nVAR\n t1 : SFB 4;\n"
      "END_VAR\nVAR_TEMP\n x : INT;\nEND_VAR\nBEGIN\nNETWORK\n CALL #t1 (PT := T#5S);\n NOP 0;\n"
      "END_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 5 FB 1\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 6\nSTRUCT\n w : WORD;\n p : ARRAY [1..2] OF INT := 3, 4;\nEND_STRUCT\nBEGIN\n"
      "END_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FB 1, DB 5 (pair := DB6.p);\n"
      "END_ORGANIZATION_BLOCK\n");
  plc.breakAt("FB 1:14");
  plc.start();
  plc.run();
  EXPECT_EQ(plc.read("#t1.PT"), "T#5S");
  EXPECT_EQ(plc.read("#pair[2]"), "4");
  EXPECT_EQ(name(plc->write({{"#pair[2]", "7"}, {"#x", "-1"}, {"#t1.PT", "T#6S"}})), "good");
  EXPECT_EQ(plc.read("DB6.p[2]"), "7");
  EXPECT_EQ(plc.read("#x"), "-1");
  EXPECT_EQ(plc.read("DB5.t1.PT"), "T#6S");
  EXPECT_EQ(plc.read("#y"), "P1216");
}

}  // namespace
}  // namespace merker::monitor::test
