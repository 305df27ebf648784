#include "step5_plc.h"

namespace merker::monitor::test {
namespace {

std::string wished(const std::optional<Problem>& problem) {
  return problem ? std::string(problem->name()) : "good";
}

std::string text(const Stacks& stacks) {
  std::string all;
  for (const BlockStackEntry& entry : stacks.blocks)
    all += toString(entry.place.block) + ":" + std::to_string(entry.place.line) + " DB " +
           std::to_string(entry.db) + (entry.organizationBlock ? " OB; " : "; ");
  return all;
}

// A block that waits stands where it goes on: behind the parameters of its call (S5-FB-06).
TEST(Step5Stacks, InHalt) {
  SinumerikPlc plc(kPress);
  plc.breakAt("FB 5:35");
  plc.start();
  plc.control().advanceTo(plc.soon());
  EXPECT_EQ(text(plc->stacks()), "FB 5:35 DB 0; OB 1:9 DB 0 OB; ");
  plc.debugger().removeBreakpoints();
  plc.breakAt("PB 5:16");
  plc.run();
  EXPECT_EQ(text(plc->stacks()), "PB 5:16 DB 10; OB 1:10 DB 0 OB; ");
  const Stacks stacks = plc->stacks();
  ASSERT_EQ(stacks.interrupts.size(), 1u);
  EXPECT_EQ(stacks.interrupts[0].registers.accu[0], 5u);
  EXPECT_TRUE(stacks.locals.empty());
  plc.debugger().removeBreakpoints();
  plc.run();
  EXPECT_TRUE(plc->stacks().empty());
}

// S5-ERR-08, S5-ERR-10: the instruction that failed, not the one behind it as REL-SAZ.
TEST(Step5Stacks, AtAnAlarm) {
  SinumerikPlc plc(kPress);
  plc.start();
  EXPECT_EQ(wished(plc->write("E 0.7", "1")), "good");
  EXPECT_EQ(plc.run().why, Pause::Why::Stop);
  EXPECT_EQ(text(plc->stacks()), "PB 6:26 DB 0; OB 1:12 DB 0 OB; ");
  const Stacks stacks = plc->stacks();
  ASSERT_EQ(stacks.interrupts.size(), 1u);
  EXPECT_EQ(stacks.interrupts[0].ob, 1);
  EXPECT_EQ(stacks.interrupts[0].registers.accu[0], 1u);
  EXPECT_EQ(plc->registers().accu[0], 1u);  // as the program left them
  const auto lines = plc->diagnostics();
  EXPECT_EQ(lines[0].eventText, "6103");
  ASSERT_TRUE(lines[0].place.has_value());
  EXPECT_EQ(lines[0].place->line, 26u);
  EXPECT_EQ(lines.back().eventText, "");  // the start has no number
  EXPECT_FALSE(lines.back().clock.has_value());
  plc.start();
  EXPECT_TRUE(plc->stacks().empty());
}

// In OB 2 the running level is that of OB 2.
// S5-BLK-07: twelve blocks, OB 1 among them, each once.
TEST(Step5Stacks, OfAnOverflow) {
  SinumerikPlc plc("OB 1\n      SPA   PB 4\n      BE\nPB 4\n      SPA   PB 4\n      BE\n");
  plc.start();
  plc.control().advanceTo(plc.soon());
  const Stacks stacks = plc->stacks();
  EXPECT_EQ(stacks.blocks.size(), 12u);
  EXPECT_EQ(toString(stacks.blocks.back().place.block), "OB 1");
}

TEST(Step5Stacks, AtAnAlarmInOb2) {
  SinumerikPlc plc("OB 1\n : BE\nOB 2\n : SPA PB 1\n : BE\nPB 1\n : T DW 0\n : BE\n");
  plc.start();
  plc.run();
  EXPECT_EQ(wished(plc->write("E 7.0", "1")), "good");
  EXPECT_EQ(plc.run().why, Pause::Why::Stop);
  EXPECT_EQ(text(plc->stacks()), "PB 1:7 DB 0; OB 2:5 DB 0 OB; ");
  EXPECT_EQ(plc->stacks().interrupts.at(0).ob, 2);
}

// Both levels: OB 2 first, and in STOP the registers of the one that failed.
TEST(Step5Stacks, OfTwoLevels) {
  SinumerikPlc plc(kInterrupted);
  plc.breakAt("OB 2:14");
  plc.start();
  EXPECT_EQ(wished(plc->write({{"E 7.0", "1"}, {"E 0.7", "1"}})), "good");
  EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
  const Stacks halted = plc->stacks();
  ASSERT_EQ(halted.interrupts.size(), 2u);
  EXPECT_EQ(halted.interrupts[0].ob, 2);
  EXPECT_EQ(halted.interrupts[0].registers.accu[0], 1u);
  EXPECT_EQ(halted.interrupts[1].ob, 1);
  EXPECT_EQ(toString(halted.interrupts[1].place.block), "FB 1");
  ASSERT_EQ(halted.blocks.size(), 3u);
  EXPECT_TRUE(halted.blocks[0].organizationBlock && halted.blocks[2].organizationBlock);
  plc.debugger().removeBreakpoints();
  EXPECT_EQ(plc.run().why, Pause::Why::Stop);
  const Stacks stopped = plc->stacks();
  EXPECT_EQ(plc.where(), "PB 1:20");
  ASSERT_EQ(stopped.blocks.size(), 4u);
  EXPECT_TRUE(stopped.blocks[1].organizationBlock && stopped.blocks[3].organizationBlock);
  ASSERT_EQ(stopped.interrupts.size(), 1u);
  EXPECT_EQ(stopped.interrupts[0].ob, 2);
}

// What stops the PLC between two instructions stops it in front of the next one.
TEST(Step5Stacks, AtAStopBetweenInstructions) {
  SinumerikPlc plc(kPress);
  plc.breakAt("PB 5:17");
  plc.start();
  plc.run();
  plc->stop();
  EXPECT_EQ(plc.control().mode(), controller::Mode::Stop);
  EXPECT_EQ(plc.where(), "PB 5:17");
  EXPECT_FALSE(plc.control().stoppedByFault());
  SinumerikPlc endless(
      "OB 1\n : SPA FB 1\nNAME : X\n : BE\nFB 1\nNAME : X\n : NOP 0\nM1 : SPA =M1\n : BE\n");
  endless.start();
  EXPECT_EQ(endless.run().why, Pause::Why::Stop);
  EXPECT_EQ(endless->diagnostics()[0].eventText, "6161");
  EXPECT_EQ(endless.where(), "FB 1:8");
}

TEST(Step5Information, ShowsWhatThereIs) {
  SinumerikPlc plc(kPress);
  ASSERT_TRUE(plc->information().raster.has_value());  // not started: no division by 0
  plc.start();
  plc.control().advanceCycles(3);
  const ModuleInformation info = plc->information();
  EXPECT_EQ(info.model, "SINUMERIK 810 GA3");
  EXPECT_EQ(info.cycles, 3u);
  EXPECT_EQ(info.blocks, 5u);
  ASSERT_TRUE(info.raster.has_value());
  EXPECT_EQ(info.raster->length, Duration::milliseconds(60));
  EXPECT_GT(info.raster->runTime.ns, 0);
  EXPECT_LT(info.raster->runTime, info.raster->length);
  EXPECT_GT(info.cycleMonitoring, 0u);
  EXPECT_EQ(info.loadMemory + info.localData, 0u);
  EXPECT_TRUE(info.clock.empty());
}

// S5-PG: all of them or none, with the constants of STEP 5; data of the NC as well.
TEST(Step5Values, AreWrittenAllOrNone) {
  SinumerikPlc plc(kPress);
  plc.start();
  EXPECT_EQ(wished(plc->write({{"MW 110", "5"}, {"DB99.DW 0", "1"}})), "P1213");
  EXPECT_EQ(wished(plc->write({{"MW 110", "5"}, {"DB1.DW 0", "1"}})), "P0988");  // S5-DB-12
  EXPECT_EQ(plc.read("MW 110"), "W#16#0000");
  EXPECT_EQ(wished(plc->write({{"MW 110", "KF -2"}, {"DB10.DW 1", "KH 00AF"}, {"nc.R 5", "3"}})),
            "good");
  EXPECT_EQ(plc.read("MW 110"), "W#16#FFFE");
  EXPECT_EQ(plc.read("DB10.DW 1"), "W#16#00AF");
  EXPECT_EQ(plc.read("nc.R 5"), "3");
  EXPECT_EQ(wished(plc->write("MB 110", "KH 0100")), "P0955");
  EXPECT_EQ(wished(plc->write("T 5", "KT 010.2")), "good");
  EXPECT_EQ(plc.read("T 5"), "KT 10.2");
}

// docs/formats/nc.md: what the NC refuses is named with what it takes; nothing of the list stays.
TEST(Step5Values, OfTheNcAreThoseThatItTakes) {
  SinumerikPlc plc(kPress);
  plc.control().couple(controlOf(kPress), nc::Side::Control);
  plc.start();
  for (const Wish& wish :
       {Wish{"nc.R 5", "123456789"}, Wish{"nc.alarm 3016", "5"}, Wish{"nc.MD 5", "1.5"},
        Wish{"nc.feed 1", "-1"}, Wish{"nc.settable_group 1", "9"}, Wish{"nc.tool 1.1", "123456789"},
        Wish{"partner nc.R 5", "123456789"}}) {
    const auto problem = plc->write({{"MW 110", "5"}, wish});
    ASSERT_EQ(wished(problem), "P0988") << wish.operand;
    EXPECT_TRUE(
        problem->message.starts_with(std::string(wish.operand) + " cannot be set: it takes "))
        << problem->message;
    EXPECT_FALSE(plc->inCycle(wish)) << wish.operand;
  }
  EXPECT_EQ(plc.read("MW 110"), "W#16#0000");
  // Each of them for itself would do, but a position in mm has three places.
  EXPECT_EQ(wished(plc->write("nc.input_system", "1")), "good");
  EXPECT_EQ(
      wished(plc->write({{"MW 110", "5"}, {"nc.input_system", "0"}, {"nc.position 1", "1.2345"}})),
      "P0988");
  EXPECT_EQ(plc.read("MW 110") + plc.read("nc.input_system"), "W#16#00001");
}

// The same constants at once and at a point of the cycle; a number is the count of a counter.
TEST(Step5Values, AreReadInOneWay) {
  SinumerikPlc plc(kPress);
  for (const Wish& wish :
       {Wish{"MW 112", "KF -2"}, Wish{"MW 112", "KH 00AF"}, Wish{"MW 112", "KY 1,2"},
        Wish{"DB10.DW 1", "KF +9"}, Wish{"MD 112", "KG +1500000+01"}, Wish{"MD 112", "70000"},
        Wish{"T 5", "KT 010.2"}, Wish{"Z 5", "KZ 12"}, Wish{"Z 5", "KF +12"}}) {
    const auto seen = plc->inCycle(wish);
    ASSERT_TRUE(seen) << wish.value << ": " << seen.error().message;
    EXPECT_EQ(wished(plc->write({wish})), "good") << wish.value;
    EXPECT_EQ(plc.control().read(seen->operand), seen->value.bits) << wish.value;
  }
  EXPECT_EQ(plc.read("Z 5"), "KZ 12");
  for (const Wish& wish : {Wish{"MW 112", "70000"}, Wish{"MB 112", "KH 0100"}}) {
    EXPECT_EQ(wished(plc->write({wish})), "P0955") << wish.value;
    EXPECT_EQ(plc->inCycle(wish).error().name(), "P0955") << wish.value;
  }
  for (const Wish& wish : {Wish{"Z 5", "KF +1000"}, Wish{"T 5", "KF +5"}})
    EXPECT_EQ(wished(plc->write({wish})), "P1210") << wish.operand;
}

// The message names what is wrong: the bit, the number, 32 bits (S5-LOAD-01, S5-BIT-01).
TEST(Step5Values, HaveTheRangesOfThePlc) {
  SinumerikPlc plc(kPress);
  for (const char* operand : {"E 0.8", "MB 256", "T 99", "EB 130", "EW 127"}) {
    EXPECT_EQ(plc.read(operand), "P1112") << operand;
    EXPECT_EQ(wished(plc->force(operand, "1")), "P1112") << operand;
    EXPECT_EQ(wished(plc->write(operand, "1")), "P1112") << operand;
  }
  for (const char* value : {"4294967296", "-2147483649"})
    EXPECT_EQ(wished(plc->write("MD 100", value)), "P0955") << value;
  EXPECT_EQ(wished(plc->write("MD 100", "4294967295")), "good");
}

// S5-NUM-04: floating point as a listing writes it, typed in the same way or with a point.
TEST(Step5Values, AreFloatingPoint) {
  SinumerikPlc plc(kPress);
  for (const char* value : {"KG +1500000+01", "+1500000+01", "1.5"}) {
    EXPECT_EQ(wished(plc->write("MD 112", "0")), "good");
    EXPECT_EQ(wished(plc->write("MD 112", value, DisplayFormat::Kg)), "good") << value;
    EXPECT_EQ(plc.read("MD 112", DisplayFormat::Kg), "KG +1500000+01") << value;
  }
  EXPECT_EQ(wished(plc->write("MD 112", "70000", DisplayFormat::Kg)), "good");
  EXPECT_EQ(plc.read("MD 112", DisplayFormat::Kg), "KG +7000000+05");
  for (const char* value : {"KF +5", "1e99", "x"})
    EXPECT_EQ(wished(plc->write("MD 112", value, DisplayFormat::Kg)), "P1210") << value;
  EXPECT_EQ(plc.read("MW 112", DisplayFormat::Kg), "P1209");
  EXPECT_EQ(wished(plc->write("MW 112", "1.5", DisplayFormat::Kg)), "P1209");
}

TEST(Step5Values, NeedATerminal) {
  cnc::Options options;
  options.plc.program = listing(kPress);
  options.plc.surroundings.modules = {{.output = false, .first = 0, .bytes = 4},
                                      {.output = false, .first = 7, .bytes = 1}};  // of OB 2
  cnc::Cnc control(std::move(options));
  source::SymbolTable symbols;
  const auto monitor =
      monitorOf(control, symbols, simulator::Resolver(step5Operand, cnc::parseConstant, true));
  EXPECT_TRUE(control.start());
  EXPECT_EQ(wished(monitor->write({{"EB 3", "1"}, {"PY 0", "1"}, {"EB 112", "1"}})), "good");
  for (const char* operand : {"EB 20", "E 20.0", "ED 2", "PY 20", "PY 100"}) {
    const auto problem = monitor->write(operand, "1");
    ASSERT_EQ(wished(problem), "P0988") << operand;
    EXPECT_NE(problem->message.find("no input module has this address"), std::string::npos);
  }
}

TEST(Step5Values, StandInTables) {
  SinumerikPlc plc(kPress);
  VariableTable& table = plc->addTable();
  for (const char* operand : {"MW 120", "DB10.DW 1", "DB99.DW 1"})
    EXPECT_EQ(wished(table.add(operand, DisplayFormat::Dec)), "good");
  EXPECT_EQ(wished(table.setModify(1, "KF +9")), "good");
  table.modifyNow();
  plc.start();
  plc.control().advanceCycles(2);
  table.monitorNow();
  EXPECT_EQ(table.text(0), "2");
  EXPECT_EQ(table.text(1), "9");
  EXPECT_EQ(table.text(2), "?");
  EXPECT_EQ(plc.read("MW 110", DisplayFormat::Dec), "13");
}

// Forcing holds flags, too; the program does not win.
TEST(Step5Force, HoldsFlags) {
  SinumerikPlc plc(kPress);
  plc.start();
  EXPECT_EQ(wished(plc->force("MW 110", "KF +1")), "good");
  EXPECT_EQ(wished(plc->write("MW 110", "2")), "P1217");
  EXPECT_EQ(wished(plc->write("MB 111", "2")), "P1217");
  plc.control().advanceCycles(2);
  EXPECT_EQ(plc.read("MW 110", DisplayFormat::Dec), "1");
  EXPECT_EQ(wished(plc->force("DB10.DW 1", "1")), "P1211");
  plc->unforceAll();
  plc.control().advanceCycles(2);
  EXPECT_EQ(plc.read("MW 110", DisplayFormat::Dec), "9");
}

// Operands of the control on the other side of a coupling are others than the own ones.
TEST(Step5Force, HoldsThoseOfThePartner) {
  const char* const copy = "OB 1\n : U E 0.0\n : = M 100.0\n : BE\n";
  SinumerikPlc plc(copy);
  plc.control().couple(controlOf(copy), nc::Side::Control);
  plc.start();
  plc.control().partner()->start();
  EXPECT_EQ(wished(plc->force("partner E 0.0", "1")), "good");
  EXPECT_EQ(wished(plc->force("partner EB 0", "0")), "P1219");
  EXPECT_EQ(wished(plc->force("EB 0", "0")), "good");
  plc.control().advanceCycles(3);
  EXPECT_EQ(plc.read("partner M 100.0") + plc.read("M 100.0"), "10");
  EXPECT_EQ(wished(plc->unforce("partner E 0.0")), "good");
  EXPECT_EQ(plc->forces().size(), 1u);
  plc.control().advanceCycles(3);
  EXPECT_EQ(plc.read("partner M 100.0"), "0");
}

}  // namespace
}  // namespace merker::monitor::test
