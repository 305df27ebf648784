#include <gtest/gtest.h>

#include "plc.h"

namespace merker::monitor::test {
namespace {

// MW 2 takes MW 0 within the cycle; MW 0 becomes 7 at its end.
const char* const kCopy =
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L MW 0;\n T MW 2;\n L 7;\n T MW 0;\n U E 0.0;\n"
    " = M 9.0;\n = A 0.0;\n U E 0.7;\n SPBN good;\n CALL SFC 46;\ngood: NOP 0;\n"
    "END_ORGANIZATION_BLOCK\n";

// S7-SIM-12: values at the beginning of the cycle are those before the program.
TEST(VariableTable, MonitorsAtItsTrigger) {
  Plc plc(kCopy);
  VariableTable& begin = plc->addTable();
  VariableTable& end = plc->addTable();
  for (VariableTable* table : {&begin, &end}) EXPECT_EQ(name(table->add("MW 0")), "good");
  begin.monitor(Trigger{CyclePoint::Begin, false});
  end.monitor(Trigger{CyclePoint::End, false});
  EXPECT_EQ(begin.text(0), "?");
  plc.start();
  plc.station().advanceCycles(1);
  EXPECT_EQ(begin.text(0), "W#16#0000");
  EXPECT_EQ(end.text(0), "W#16#0007");
}

TEST(VariableTable, ModifiesAtItsTrigger) {
  Plc plc(kCopy);
  VariableTable& table = plc->addTable();
  EXPECT_EQ(name(table.add("MW 0", DisplayFormat::Dec)), "good");
  EXPECT_EQ(name(table.setModify(0, "33")), "good");
  plc.start();
  table.modify(Trigger{CyclePoint::Begin, true});
  plc.station().advanceCycles(1);
  EXPECT_EQ(plc.read("MW 2", DisplayFormat::Dec), "33");
  EXPECT_FALSE(table.modifying());  // once
  plc.station().advanceCycles(1);
  EXPECT_EQ(plc.read("MW 2", DisplayFormat::Dec), "7");
  table.modify(Trigger{CyclePoint::End, false});
  plc.station().advanceCycles(3);
  EXPECT_EQ(plc.read("MW 0", DisplayFormat::Dec), "33");
}

// An input that is modified at the beginning of the cycle is seen by this cycle.
TEST(VariableTable, ModifiesInputsBeforeTheProgram) {
  Plc plc(kCopy);
  VariableTable& table = plc->addTable();
  EXPECT_EQ(name(table.add("E 0.0")), "good");
  EXPECT_EQ(name(table.setModify(0, "TRUE")), "good");
  plc.start();
  table.modify(Trigger{CyclePoint::Begin, false});
  plc.station().advanceCycles(1);
  EXPECT_EQ(plc.read("M 9.0"), "1");
  table.modify({});
  plc.station().advanceCycles(1);
  EXPECT_EQ(plc.read("M 9.0"), "0");  // the terminal never was 1
}

TEST(VariableTable, ActsAtTheTransitionToStop) {
  Plc plc(kCopy);
  VariableTable& table = plc->addTable();
  EXPECT_EQ(name(table.add("MW 50", DisplayFormat::Hex)), "good");
  EXPECT_EQ(name(table.setModify(0, "AFFE")), "good");
  plc.start();
  table.modify(Trigger{CyclePoint::Stop, false});
  table.monitor(Trigger{CyclePoint::Stop, true});
  plc.station().advanceCycles(2);
  EXPECT_EQ(table.text(0), "?");
  plc.station().stop();
  EXPECT_EQ(plc.read("MW 50"), "W#16#AFFE");
  EXPECT_EQ(table.text(0), "W#16#AFFE");
}

TEST(VariableTable, ActsAtOnce) {
  Plc plc(kCopy);
  VariableTable& table = plc->addTable();
  EXPECT_EQ(name(table.add("MW 60")), "good");
  EXPECT_EQ(name(table.setModify(0, "12")), "good");
  table.modifyNow();
  table.monitorNow();
  EXPECT_EQ(table.text(0), "W#16#000C");
  EXPECT_EQ(name(table.setFormat(0, DisplayFormat::Dec)), "good");
  EXPECT_EQ(table.text(0), "12");  // the format changes, the value stays
  plc->removeTable(table);
}

TEST(VariableTable, RefusesWhatDoesNotFit) {
  Plc plc(kCopy);
  VariableTable& table = plc->addTable();
  EXPECT_EQ(name(table.add("MW 0", DisplayFormat::Real)), "P1209");
  EXPECT_EQ(name(table.add("QWERTZ")), "P0317");
  EXPECT_TRUE(table.rows().empty());
  EXPECT_EQ(name(table.add("MB 0")), "good");
  EXPECT_EQ(name(table.setModify(0, "256")), "P0955");
  EXPECT_EQ(name(table.setModify(0, "")), "good");
  EXPECT_FALSE(table.rows()[0].modify);
}

struct Typed {
  const char* operand;
  DisplayFormat format;
  const char* text;
  const char* shown;  // or the problem
};

// A duration is one however it is written; what is no value of the format is refused, not taken
// bit by bit (S7-SIM-12, S7-MGR-16).
TEST(VariableTable, TakesValuesOfTheFormatOnly) {
  using enum DisplayFormat;
  for (const Typed& one : {Typed{"T 1", Automatic, "5000", "P1210"},
                           {"MW 20", S5Time, "T#5S", "S5T#5S"},
                           {"MW 20", S5Time, "T#4H", "P1210"},
                           {"MD 20", Time, "S5T#1S", "T#1S"},
                           {"MD 20", Time, "1.5", "P1210"},
                           {"MD 20", Real, "T#5S", "P1210"},
                           {"MD 20", Real, "7", "7.000000e+000"},
                           {"MW 20", Counter, "-1", "P1210"},
                           {"MW 20", Counter, "12", "C#12"},
                           {"Z 1", Automatic, "S5T#1S", "P1210"},
                           {"Z 1", Automatic, "1000", "P1210"},
                           {"Z 1", Dec, "12", "12"},
                           {"MW 20", Dec, "+7", "7"},
                           {"MW 20", Dec, "W#16#000A", "10"},
                           {"MW 20", Hex, "1.5", "P1210"},
                           {"M 0.0", Automatic, "1", "1"}}) {
    Plc plc(kCopy);
    VariableTable& table = plc->addTable();
    EXPECT_EQ(name(table.add(one.operand, one.format)), "good");
    std::string seen = name(table.setModify(0, one.text));
    table.modifyNow();
    table.monitorNow();
    if (seen == "good") seen = table.text(0);
    EXPECT_EQ(seen, one.shown) << one.operand << ' ' << one.text;
  }
}

// S7-SIM-12, S7-CPU-31: a force holds against the program and the terminals.
TEST(Force, HoldsUntilItIsTakenAway) {
  Plc plc(kCopy);
  plc.start();
  EXPECT_EQ(name(plc->force("E 0.0", "1")), "good");
  EXPECT_EQ(name(plc->force("A 0.0", "0")), "good");
  plc.station().advanceCycles(2);
  EXPECT_EQ(plc.read("M 9.0"), "1");
  EXPECT_EQ(plc.read("A 0.0"), "0");
  EXPECT_EQ(plc->forces().size(), 2u);
  EXPECT_EQ(name(plc->unforce("A 0.0")), "good");
  plc.station().advanceCycles(2);
  EXPECT_EQ(plc.read("A 0.0"), "1");
  EXPECT_EQ(name(plc->unforce("A 0.0")), "P1214");
  plc->unforceAll();
  plc.station().advanceCycles(2);
  EXPECT_EQ(plc.read("M 9.0"), "0");
  EXPECT_EQ(name(plc->force("T 1", "0")), "P1211");
}

TEST(Force, TakesNoBitTwice) {
  Plc plc(kCopy);
  EXPECT_EQ(name(plc->force("E 0.0", "0")), "good");
  EXPECT_EQ(name(plc->force("EB 0", "B#16#01")), "P1219");
  EXPECT_EQ(name(plc->force("E 0.1", "1")), "good");
  EXPECT_EQ(name(plc->force("E 0.0", "1")), "good");  // its new value
  EXPECT_EQ(name(plc->force({{"A 0.0", "1"}, {"AW 0", "W#16#1"}})), "P1219");
  EXPECT_EQ(plc->forces().size(), 2u);
}

TEST(Force, EndsWithAMemoryReset) {
  Plc plc(kCopy);
  EXPECT_EQ(name(plc->force("E 0.0", "1")), "good");
  plc.station().stop();
  plc.station().memoryReset();
  EXPECT_TRUE(plc->forces().empty());
  EXPECT_EQ(name(plc->force("EB 0", "B#16#01")), "good");
}

// S7-SIM-12: DATE_AND_TIME and STRING are shown and modified whole.
TEST(VariableTable, HoldsStringsAndDates) {
  Plc plc(
      "DATA_BLOCK DB 1\nSTRUCT\n s : STRING [5] := 'abc';\n d : DT;\nEND_STRUCT\nBEGIN\n"
      "END_DATA_BLOCK\n" +
      std::string(kCopy));
  VariableTable& table = plc->addTable();
  EXPECT_EQ(name(table.add("DB1.s")), "good");
  EXPECT_EQ(name(table.add("DB1.d", DisplayFormat::Hex)), "P1209");
  EXPECT_EQ(name(table.setModify(0, "'toolong'")), "P0961");
  EXPECT_EQ(name(table.setModify(0, "'xy'")), "good");
  table.modifyNow();
  table.monitorNow();
  EXPECT_EQ(table.text(0), "'xy'");
  EXPECT_EQ(plc.read("DB1.DBW 0"), "W#16#0502");
}

// S7-SIM-12: one wish that cannot be carried out stops all of them.
TEST(Monitor, WritesAllOrNothing) {
  Plc plc(kCopy);
  EXPECT_EQ(name(plc->write("T 1", "S5T#1S")), "good");  // S7-SIM-03
  EXPECT_EQ(plc.read("T 1"), "S5T#1S");
  EXPECT_EQ(name(plc->write({{"MW 10", "5"}, {"MB 12", "256"}})), "P0955");
  EXPECT_EQ(plc.read("MW 10", DisplayFormat::Dec), "0");
  EXPECT_EQ(name(plc->force({{"E 0.0", "1"}, {"M 0.0", "1"}})), "P1211");
  EXPECT_TRUE(plc->forces().empty());
  EXPECT_EQ(plc.read("E 0.0"), "0");
  EXPECT_EQ(name(plc->write({{"MW 10", "5"}, {"MB 12", "255"}})), "good");
  EXPECT_EQ(plc.read("MW 10", DisplayFormat::Dec), "5");
}

}  // namespace
}  // namespace merker::monitor::test
