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
  address::Reference flag{.text = "",
                          .operand = address::memory(Area::Flag, Width::Word, bitAddress(255))};
  EXPECT_FALSE(station.read(flag));
  EXPECT_FALSE(station.write(flag, 1));
  address::Reference block{
      .text = "", .operand = address::memory(Area::DataBlock, Width::Word, 0), .db = 5};
  EXPECT_FALSE(station.read(block));
  address::Reference timer{.text = "",
                           .operand = {.kind = address::OperandKind::Timer, .value = 300}};
  EXPECT_FALSE(station.read(timer));
}

// PE: the input terminals; PA: the output side, and the output image with it (S7-OPND-07,
// S7-OPND-10).
TEST(Values, PeripheryHasTwoSides) {
  Plc plc("L PEB 4; T PAB 5;");
  plc.write("E 4.1", 1);
  EXPECT_EQ(plc.read("PEB 4"), 2u);
  EXPECT_EQ(plc.read("PAB 4"), 0u);
  plc.write("PEB 4", 0x81);
  plc.cycles(2);
  EXPECT_EQ(plc.read("EB 4"), 0x81u);
  EXPECT_EQ(plc.read("PAB 5"), 0x81u);
  EXPECT_EQ(plc.read("PEB 5"), 0u);
  plc.write("PAB 6", 7);
  EXPECT_EQ(plc.read("AB 6"), 7u);
  EXPECT_EQ(plc.read("EB 6"), 0u);
}

TEST(Values, DateAndTimeAndStringAreBytes) {
  Plc plc(
      "DATA_BLOCK DB 1\nSTRUCT\n t : DATE_AND_TIME := DT#1998-04-14-17:53:17.333;\n"
      " s : STRING [5] := 'ab';\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n");
  using Bytes = std::vector<std::uint8_t>;
  const auto time = plc.reference("DB1.t"), text = plc.reference("DB1.s");
  EXPECT_EQ(plc->readBytes(time), (Bytes{0x98, 0x04, 0x14, 0x17, 0x53, 0x17, 0x33, 0x33}));
  EXPECT_EQ(plc->readBytes(text), (Bytes{5, 2, 'a', 'b', 0, 0, 0}));
  EXPECT_TRUE(plc->writeBytes(text, Bytes{5, 1, 'x', 0, 0, 0, 0}));
  EXPECT_EQ(plc.read("DB1.DBW 8"), 0x0501u);
  EXPECT_FALSE(plc->writeBytes(text, Bytes{1}));
  address::Reference outside = text;
  outside.bytes = 9;
  EXPECT_FALSE(plc->readBytes(outside));
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

TEST(Force, ActsAtOnce) {
  Plc plc("U E 0.0; = A 4.0;");
  plc.cycles(2);
  plc.force("E 0.0", 1);
  EXPECT_EQ(plc.read("E 0.0"), 1u);
  plc.force("A 4.1", 1);
  EXPECT_EQ(plc.read("A 4.1"), 1u);
  EXPECT_EQ(plc.read("PAB 4"), 2u);
  EXPECT_FALSE(plc.force("MW 10", 0x1234));  // S7-CPU-31: E and A of the process image alone
  EXPECT_EQ(plc.read("MB 11"), 0u);
}

// The outputs are off in STOP; so are forced ones (S7-STATE-02).
TEST(Force, LeavesTheOutputsOffInStop) {
  Plc plc("NOP 0;");
  plc.cycles(1);
  plc->stop();
  plc.force("A 4.1", 1);
  EXPECT_EQ(plc.read("PAB 4"), 0u);
}

}  // namespace
}  // namespace merker::station::test
