#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

using Bytes = std::vector<std::uint8_t>;

// S7-SRC-05, S7-SRC-08, S7-TYPES-18 … 21: start values and actual values in their bytes.
TEST(Declaration, DataBlockBytes) {
  const Compiled compiled = compileText(
      "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [1..3] OF INT := 1, 2 (7);\n s : STRING [4] := 'AB';\n "
      "b : BOOL := TRUE; c : BOOL;\n"
      " m : ARRAY [0..1, 1..2] OF BYTE := 4 (B#16#5);\n r : REAL := 1.0;\nEND_STRUCT;\nBEGIN\n "
      "a[2] := -1;\n c := TRUE;\n m[1,1] := 9;\nEND_DATA_BLOCK\n");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  const block::Block& db = compiled.block(BlockKind::DB, 1);
  EXPECT_EQ(db.initialData,
            (Bytes{0, 1, 0, 7, 0, 7, 4, 2, 'A', 'B', 0, 0, 1, 0, 5, 5, 5, 5, 0x3F, 0x80, 0, 0}));
  EXPECT_EQ(db.actualData, (Bytes{0, 1, 0xFF, 0xFF, 0, 7, 4, 2,    'A',  'B', 0,
                                  0, 3, 0,    5,    5, 9, 5, 0x3F, 0x80, 0,   0}));
}

// S7-TYPES-28, S7-SRC-09: UDTs and FBs may stand behind their use.
TEST(Declaration, OrderOfBlocksDoesNotMatter) {
  const Compiled compiled = compileText(
      "DATA_BLOCK DB 2\nFB 1\nBEGIN\n v.y := 3;\nEND_DATA_BLOCK\nDATA_BLOCK DB 1\nUDT "
      "1\nEND_DATA_BLOCK\n"
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n v : UDT 1;\nEND_VAR\nBEGIN\nL #v.y\nEND_FUNCTION_BLOCK\n"
      "TYPE UDT 1\nSTRUCT\n x : BOOL; y : INT := 2;\nEND_STRUCT\nEND_TYPE\n");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_EQ(compiled.block(BlockKind::DB, 1).actualData, (Bytes{0, 0, 0, 2}));
  EXPECT_EQ(compiled.block(BlockKind::DB, 2).actualData, (Bytes{0, 0, 0, 3}));
  EXPECT_EQ(compiled.block(BlockKind::DB, 2).instanceOf, 1);
}

// S7-FB-03, S7-FB-06: addresses of the FB of chapter 14, its instance with an own start value.
TEST(Declaration, InstanceOfTheCourse) {
  const Compiled compiled = compileText(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n FPIn : INT;\nEND_VAR\nVAR_OUTPUT\n FPOut : "
      "WORD;\nEND_VAR\nVAR_IN_OUT\n FPInOut : BYTE;\nEND_VAR\n"
      "VAR\n Statisch : BOOL;\nEND_VAR\nVAR_TEMP\n Tempo : "
      "INT;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\n Statisch := "
      "TRUE;\nEND_DATA_BLOCK\n");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  std::vector<BitAddress> addresses;
  for (const block::Variable& variable : compiled.block(BlockKind::FB, 1).variables)
    addresses.push_back(variable.address);
  EXPECT_EQ(addresses, (std::vector<BitAddress>{0, 16, 32, 48, 0}));
  EXPECT_EQ(compiled.block(BlockKind::DB, 1).actualData, (Bytes{0, 0, 0, 0, 0, 0, 1, 0}));
}

// S7-FC-09: own temporary data of an OB begin behind the start information, unless the source
// declares that.
TEST(Declaration, StartInformationOfAnOb) {
  const auto address = [](std::string_view temps) {
    const Compiled compiled =
        compileText("ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n" + std::string(temps) +
                    "\nEND_VAR\nBEGIN\nEND_ORGANIZATION_BLOCK\n");
    return compiled.block(BlockKind::OB, 1).variables.back().address / 8;
  };
  EXPECT_EQ(address("w : WORD;"), 20u);
  EXPECT_EQ(address("OB1_EV_CLASS : BYTE; OB1_SCAN_1 : BYTE;"), 1u);
  EXPECT_EQ(address("info : ARRAY [1..20] OF BYTE; w : WORD;"), 20u);
}

TEST(Declaration, HeaderAttributes) {
  const Compiled compiled = compileText(
      "FUNCTION_BLOCK FB 1\nTITLE = Motor\n{ S7_m_c := 'true' }\nKNOW_HOW_PROTECT\nAUTHOR : "
      "me\nFAMILY : Drives\nNAME : Motor\nVERSION : 1.2\nCODE_VERSION1\nBEGIN\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 1\nREAD_ONLY\nNON_RETAIN\nSTRUCT\n a : "
      "INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  const block::Attributes& fb = compiled.block(BlockKind::FB, 1).attributes;
  EXPECT_EQ(fb.title + fb.author + fb.family + fb.name, "MotormeDrivesMotor");
  EXPECT_EQ(fb.version, 0x12);
  EXPECT_TRUE(fb.knowHowProtect && fb.codeVersion1);
  ASSERT_EQ(fb.system.size(), 1u);
  EXPECT_EQ(fb.system[0].first, "S7_m_c");
  const block::Attributes& db = compiled.block(BlockKind::DB, 1).attributes;
  EXPECT_TRUE(db.readOnly && db.nonRetain && !db.unlinked);
}

}  // namespace
}  // namespace merker::step7
