#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cpu/cpu.h"
#include "program.h"

namespace merker::station::test {
namespace {

constexpr std::string_view kDb =
    "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [1..20] OF BYTE;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

Plc plcWith(std::string_view body) {
  return Plc(std::string(kDb) +
             "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\n any : "
             "ANY;\nEND_VAR\nBEGIN\n" +
             std::string(body) + "\nEND_ORGANIZATION_BLOCK\n");
}

// S7-SFC-08, S7-TYPES-26, S7-IND-15: the shorter side decides.
TEST(BlockMove, Copies) {
  Plc plc = plcWith(
      "L DW#16#11223344; T MD 10; L DW#16#55667788; T MD 14;"
      "CALL SFC 20 (SRCBLK := P#M10.0 BYTE 6, RET_VAL := MW 0, DSTBLK := P#DB1.DBX2.0 BYTE 10);"
      "CALL SFC 20 (SRCBLK := DB1.a, RET_VAL := MW 2, DSTBLK := P#M30.0 BYTE 8);");
  plc.cycles(1);
  ASSERT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  EXPECT_EQ(plc.read("MW 0"), 0u);
  EXPECT_EQ(plc.read("DB1.DBD 2"), 0x11223344u);
  EXPECT_EQ(plc.read("DB1.DBD 6"), 0x55660000u);
  EXPECT_EQ(plc.read("MD 30"), 0x00001122u);
  EXPECT_EQ(plc.read("MD 34"), 0x33445566u);
}

// S7-SFC-01: W#16#8122 and BIE 0 for a source beyond M.
TEST(BlockMove, ReportsWhatIsWrong) {
  Plc plc = plcWith(
      "CALL SFC 20 (SRCBLK := P#M250.0 BYTE 10, RET_VAL := MW 0, DSTBLK := P#M10.0 BYTE 10); UN "
      "BIE; = M 20.0;"
      "CALL SFC 20 (SRCBLK := P#M10.0 BYTE 10, RET_VAL := MW 2, DSTBLK := P#DB1.DBX16.0 BYTE 10);"
      "CALL SFC 20 (SRCBLK := P#DB9.DBX0.0 BYTE 10, RET_VAL := MW 4, DSTBLK := P#M10.0 BYTE 10);");
  plc.cycles(1);
  EXPECT_EQ(plc.read("MW 0"), 0x8122u);
  EXPECT_EQ(plc.read("M 20.0"), 1u);
  EXPECT_EQ(plc.read("MW 2"), 0x8323u);
  EXPECT_EQ(plc.read("MW 4"), 0x813Au);
}

// S7-SFC-01: no ANY, and bits that are no whole bytes.
TEST(BlockMove, ReportsWhatIsNoAny) {
  Plc plc = plcWith(
      "L W#16#0102; T LW 20; L 4; T LW 22; L 0; T LW 24; L P#M50.0; T LD 26;"
      "CALL SFC 20 (SRCBLK := #any, RET_VAL := MW 0, DSTBLK := P#M60.0 BYTE 4);"
      "CALL SFC 21 (BVAL := P#M 60.0 BYTE 4, RET_VAL := MW 2, BLK := #any);"
      "CALL SFC 20 (SRCBLK := P#M 50.0 BOOL 15, RET_VAL := MW 4, DSTBLK := P#M60.0 BYTE 4);"
      "CALL SFC 20 (SRCBLK := P#M 50.0 BYTE 4, RET_VAL := MW 6, DSTBLK := P#M60.0 BOOL 9);"
      "CALL SFC 20 (SRCBLK := P#M 50.0 BOOL 16, RET_VAL := MW 8, DSTBLK := P#M60.0 BOOL 16);");
  plc.cycles(1);
  EXPECT_EQ(plc.read("MW 0"), 0x8101u);
  EXPECT_EQ(plc.read("MW 2"), 0x8301u);
  EXPECT_EQ(plc.read("MW 4"), 0x8122u);
  EXPECT_EQ(plc.read("MW 6"), 0x8323u);
  EXPECT_EQ(plc.read("MW 8"), 0u);
}

// S7-IND-17: an ANY that the program builds itself.
TEST(BlockMove, TakesAnAnyFromLocalData) {
  Plc plc = plcWith(
      "L W#16#1002; T LW 20; L 4; T LW 22; L 0; T LW 24; L P#M50.0; T LD 26; L DW#16#A1B2C3D4; T "
      "MD 50;"
      "CALL SFC 20 (SRCBLK := #any, RET_VAL := MW 0, DSTBLK := P#M60.0 BYTE 4);");
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 60"), 0xA1B2C3D4u);
}

// S7-SFC-09: the last copy is cut off.
TEST(Fill, Repeats) {
  Plc plc = plcWith(
      "L DW#16#01020300; T MD 10; CALL SFC 21 (BVAL := P#M10.0 BYTE 3, RET_VAL := MW 0, BLK := "
      "P#M20.0 BYTE 10);");
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 20"), 0x01020301u);
  EXPECT_EQ(plc.read("MD 24"), 0x02030102u);
  EXPECT_EQ(plc.read("MW 28"), 0x0301u);
  EXPECT_EQ(plc.read("MB 30"), 0u);
}

// S7-SFC-10
TEST(DataBlocks, AreMadeTestedAndDeleted) {
  Plc plc = plcWith(
      "CALL SFC 22 (LOW_LIMIT := W#16#1, UP_LIMIT := W#16#5, COUNT := W#16#A, RET_VAL := MW 0, "
      "DB_NUMBER := MW 2);"
      "AUF DB [MW 2]; L DBLG; T MW 4; L 5; T DBW 8;"
      "CALL SFC 24 (DB_NUMBER := MW 2, RET_VAL := MW 6, DB_LENGTH := MW 8, WRITE_PROT := M 20.0);"
      "CALL SFC 23 (DB_NUMBER := MW 2, RET_VAL := MW 10); L DBLG; T MW 12;"
      "CALL SFC 24 (DB_NUMBER := MW 2, RET_VAL := MW 14, DB_LENGTH := MW 16, WRITE_PROT := M 20.1);"
      "CALL SFC 22 (LOW_LIMIT := W#16#0, UP_LIMIT := W#16#5, COUNT := W#16#A, RET_VAL := MW 18, "
      "DB_NUMBER := MW 22);"
      "CALL SFC 22 (LOW_LIMIT := W#16#1, UP_LIMIT := W#16#5, COUNT := W#16#9, RET_VAL := MW 24, "
      "DB_NUMBER := MW 22);");
  plc.cycles(1);
  ASSERT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  EXPECT_EQ(plc.read("MW 0"), 0u);
  EXPECT_EQ(plc.read("MW 2"), 2u);
  EXPECT_EQ(plc.read("MW 4"), 10u);
  EXPECT_EQ(plc.read("MW 6"), 0u);
  EXPECT_EQ(plc.read("MW 8"), 10u);
  EXPECT_EQ(plc.read("MW 10"), 0u);
  EXPECT_EQ(plc.read("MW 12"), 0u);
  EXPECT_EQ(plc.read("MW 14"), 0x80B1u);
  EXPECT_EQ(plc.read("MW 18"), 0x80A1u);
  EXPECT_EQ(plc.read("MW 24"), 0x80A2u);
}

// S7-SFC-24
TEST(BitField, SetsAndResetsARange) {
  Plc plc = plcWith(
      "CALL SFC 79 (N := 8, RET_VAL := MW 0, SA := P#A 4.2); L PEB 0; CALL SFC 80 (N := 2, RET_VAL "
      ":= MW 2, SA := P#A 4.4);");
  plc.cycles(1);
  ASSERT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  EXPECT_EQ(plc.read("AB 4"), 0xCCu);
  EXPECT_EQ(plc.read("AB 5"), 0x03u);
  EXPECT_EQ(plc.read("PAB 4"), 0xCCu);
}

// S7-SFC-05
TEST(StartInfo, NamesTheRunningOb) {
  Plc plc(
      "ORGANIZATION_BLOCK OB 35\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n"
      "CALL SFC 6 (RET_VAL := MW 0, TOP_SI := P#M10.0 BYTE 12, START_UP_SI := P#M30.0 BYTE "
      "12);\nEND_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF "
      "BYTE;\nEND_VAR\nBEGIN\nEND_ORGANIZATION_BLOCK\n");
  plc.start();
  plc.run(Duration::milliseconds(110));
  EXPECT_EQ(plc.read("MB 13"), 35u);
}

// S7-SFC-05: START_UP_SI is the startup before, in OB 1 and in OB 121 alike.
TEST(StartInfo, KeepsThatOfTheStartup) {
  constexpr std::string_view kCall =
      "CALL SFC 6 (RET_VAL := MW 0, TOP_SI := P#M{}.0 BYTE 12, START_UP_SI := P#M{}.0 BYTE 12);";
  Plc plc(ob(100, " NOP 0;") + ob(121, fmt::format(kCall, 10, 30)) +
          ob(1, fmt::format(kCall, 50, 70) + "AUF DB 99;"));
  plc.cycles(1);
  ASSERT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  EXPECT_EQ(plc.read("MB 13"), 121u);
  EXPECT_EQ(plc.read("MB 53"), 1u);
  EXPECT_EQ(plc.read("MD 30"), 0x13811B64u);
  EXPECT_EQ(plc.read("MD 70"), 0x13811B64u);
}

// S7-SFC-05: code of STEP 7 hands a STRUCT over by POINTER. The entries of the list are turned to
// those in local data.
TEST(StartInformation, IntoAStructByPointer) {
  auto program = std::make_shared<block::Program>(*compileAwl(
      "L 0; T LW 200; T LW 206; L P#M 100.0; T LD 202; L P#M 120.0; T LD 208;"
      "CALL SFC 6 (RET_VAL := MW 20, TOP_SI := P#M 60.0 BYTE 12, START_UP_SI := P#M 80.0 BYTE 12);",
      defaultCpuModel()));
  std::vector<std::uint8_t>& code = program->at({BlockKind::OB, 1}).code;
  const std::uint8_t jump[] = {0x70, 0x0B, 0x00, 0x08};  // over three entries: RET_VAL is the first
  const auto list = std::search(code.begin(), code.end(), std::begin(jump), std::end(jump));
  ASSERT_NE(list, code.end());
  const std::uint8_t local[] = {0x87, 0, 0x06, 0x40, 0x87, 0, 0x06, 0x70};  // V 200.0, V 206.0
  std::copy(std::begin(local), std::end(local), list + 8);
  Station plc({.program = program});
  ASSERT_TRUE(plc.warmRestart());
  plc.advanceCycles(2);
  const std::uint8_t* flags = plc.cpu().machine().areas.flag(0);
  EXPECT_EQ(flags[20] << 8 | flags[21], 0);
  EXPECT_EQ(flags[100], 0x11);  // OB 1
  EXPECT_EQ(flags[103], 1);
  EXPECT_EQ(flags[120], 0x13);  // OB 100
  EXPECT_EQ(flags[123], 100);
  EXPECT_EQ(flags[60], 0);
}

}  // namespace
}  // namespace merker::station::test
