#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

TEST(Values, AreReadAndWritten) {
  Plc plc(
      "DATA_BLOCK DB 1\nSTRUCT\n a : INT := 3;\n b : BOOL;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF "
      "BYTE;\nEND_VAR\nBEGIN\nEND_ORGANIZATION_BLOCK\n");
  plc.write("MW 10", 0x1234);
  EXPECT_EQ(plc.read("MB 10"), 0x12u);
  plc.write("M 10.7", 1);
  EXPECT_EQ(plc.read("MW 10"), 0x9234u);
  plc.write("M 10.7", 0);
  EXPECT_EQ(plc.read("MW 10"), 0x1234u);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 3u);
  plc.write("DB1.DBX 2.0", 1);
  EXPECT_EQ(plc.read("DB1.b"), 1u);
}

TEST(Values, OutsideGiveNothing) {
  Station station({});
  mc7::Reference flag{.text = "", .operand = mc7::memory(Area::Flag, Width::Word, bitAddress(255))};
  EXPECT_FALSE(station.read(flag));
  EXPECT_FALSE(station.write(flag, 1));
  mc7::Reference block{
      .text = "", .operand = mc7::memory(Area::DataBlock, Width::Word, 0), .db = 5};
  EXPECT_FALSE(station.read(block));
  mc7::Reference timer{.text = "", .operand = {.kind = mc7::OperandKind::Timer, .value = 300}};
  EXPECT_FALSE(station.read(timer));
}

// A force holds against terminal and program.
TEST(Force, Holds) {
  Plc plc("U E 0.0; = A 4.0; SET; = A 4.1; SET; = M 1.0;");
  EXPECT_TRUE(plc.force("E 0.0", 1));
  EXPECT_TRUE(plc.force("A 4.1", 0));
  plc.cycles(2);
  EXPECT_EQ(plc.read("A 4.0"), 1u);
  EXPECT_EQ(plc.read("A 4.1"), 0u);
  EXPECT_EQ(plc.read("PAB 4"), 1u);
  plc->unforce();
  plc->advanceCycles(2);
  EXPECT_EQ(plc.read("A 4.0"), 0u);
  EXPECT_EQ(plc.read("A 4.1"), 1u);
  EXPECT_FALSE(plc.force("PEB 4", 0));
}

}  // namespace
}  // namespace merker::station::test
