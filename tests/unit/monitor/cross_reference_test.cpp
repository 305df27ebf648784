#include <gtest/gtest.h>

#include <algorithm>

#include "monitor/assignment_list.h"
#include "monitor/block_list.h"
#include "plc.h"

namespace merker::monitor::test {
namespace {

const char* const kUses =
    "DATA_BLOCK DB 1\nSTRUCT\n a : WORD;\n b : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"  // 1..7
    "FUNCTION FC 1 : VOID\nVAR_INPUT\n in : INT;\nEND_VAR\nVAR_OUTPUT\n out : INT;\nEND_VAR\n"
    "VAR_IN_OUT\n both : BOOL;\nEND_VAR\nBEGIN\nNETWORK\n NOP 0;\nEND_FUNCTION\n"  // 8..21
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"                                    // 22..24
    " U E 0.0;\n FP M 1.0;\n S A 0.1;\nNETWORK\n"                                  // 25..28
    " L MW 10;\n T DB1.DBW 2;\n SE T 5;\n ZV Z 3;\n"                               // 29..32
    " L MW [MD 20];\n CALL FC 1 (in := MW 30, out := MW 32, both := M 40.0);\n"    // 33..34
    " CALL SFC 64 (RET_VAL := MD 50);\nEND_ORGANIZATION_BLOCK\n";

struct Uses : ::testing::Test {
  Plc plc{kUses, "\"Start\" E 0.0 BOOL\n\"Spare\" E 7.7 BOOL\n\"Adder\" FC 1\n\"Main\" OB 1\n"};
  block::Program library = system::library(defaultCpuModel());
  std::vector<CrossReference> list =
      crossReferences(plc.program(), plc.symbols(), {.library = &library});
  std::string text(const std::vector<CrossReference>& rows) const {
    std::string result;
    for (const CrossReference& row : rows)
      result += row.operand + " " + std::string(monitor::name(row.use)) + " " +
                std::to_string(row.place.line) + "; ";
    return result;
  }
  std::string of(const std::string& filter) {
    const auto part = filtered(list, filter, plc.resolver(), step7Words(), plc.symbols());
    return part ? text(*part) : std::string(part.error().name());
  }
};

// S7-EDIT-22: every use with its place, read or write, in STEP 7's order.
TEST_F(Uses, AreListed) {
  EXPECT_EQ(text(list),
            "E 0.0 R 25; A 0.1 W 27; M 1.0 RW 26; MW 10 R 29; MD 20 R 33; MW 30 R 34; MW 32 W 34; "
            "M 40.0 RW 34; MD 50 W 35; T 5 W 31; Z 3 W 32; DB1.DBW 2 W 30; DB 1 - 30; FC 1 - 34; "
            "SFC 64 - 35; ");
  EXPECT_EQ(list[0].symbol, "Start");
  EXPECT_EQ(list[0].instruction, "U     E 0.0");
  EXPECT_EQ(list[3].place.network, 2u);
  EXPECT_EQ(list[3].statement, 1u);
  EXPECT_EQ(list[1].statement, 3u);
}

// S7-EDIT-22: by operand; accesses that overlap belong to it.
TEST_F(Uses, CanBeFiltered) {
  EXPECT_EQ(of("MB 11"), "MW 10 R 29; ");
  EXPECT_EQ(of("M 33.7, \"Start\""), "E 0.0 R 25; MW 32 W 34; ");
  EXPECT_EQ(of("DB 1"), "DB1.DBW 2 W 30; DB 1 - 30; ");
  EXPECT_EQ(of("\"Adder\""), "FC 1 - 34; ");
  EXPECT_EQ(of("\"Main\""), "");
  EXPECT_EQ(of("DB1.DBB 3"), "DB1.DBW 2 W 30; ");
  EXPECT_EQ(of("T"), "T 5 W 31; ");
  EXPECT_EQ(of("c 3"), "Z 3 W 32; ");
  EXPECT_EQ(of("SFC"), "SFC 64 - 35; ");
  EXPECT_EQ(of("MB 200"), "");
  EXPECT_EQ(of("nonsense"), "P0317");
}

TEST_F(Uses, ShowWhatIsUnused) {
  const auto unused = unusedSymbols(list, plc.symbols());
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_EQ(unused[0].name, "Spare");
  EXPECT_EQ(operandsWithoutSymbol(list).front(), "A 0.1");
}

// S7-EDIT-22: the assignment list.
TEST_F(Uses, MakeTheAssignmentList) {
  const AssignmentList assignment = assignmentList(list);
  EXPECT_EQ(assignment.timers, std::vector<std::uint32_t>{5});
  EXPECT_EQ(assignment.counters, std::vector<std::uint32_t>{3});
  ASSERT_GE(assignment.bytes.size(), 5u);
  EXPECT_EQ(assignment.bytes[0].area, Area::Input);
  EXPECT_TRUE(assignment.bytes[0].bits[0]);
  EXPECT_FALSE(assignment.bytes[0].bits[1]);
  EXPECT_EQ(assignment.bytes[3].byte, 10u);
  EXPECT_TRUE(assignment.bytes[3].byWord);
  EXPECT_EQ(assignment.bytes[4].byte, 11u);
  EXPECT_FALSE(assignment.bytes[4].byByte);
}

TEST_F(Uses, BlocksAreListed) {
  const auto blocks = blockList(plc.program());
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_EQ(blocks[2].id.number, 1);
  EXPECT_GT(blocks[0].load, blocks[0].work);
}

// DB 1: s at 0, d at 6; FB 1 with its instance DB 10.
const char* const kCalls =
    "DATA_BLOCK DB 1\nSTRUCT\n s : STRING [4];\n d : DT;\n w : WORD;\nEND_STRUCT\nBEGIN\n"
    "END_DATA_BLOCK\n"                                                                      // 8
    "DATA_BLOCK DB 3\nSTRUCT\n a : WORD;\n b : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"  // 15
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\n q : BOOL;\n a : ANY;\n t : TIMER;\nEND_VAR\nVAR_IN_OUT\n"
    " io : INT;\n s : STRING;\nEND_VAR\nBEGIN\nNETWORK\n NOP 0;\nEND_FUNCTION_BLOCK\n"  // 29
    "FUNCTION FC 1 : VOID\nVAR_INPUT\n b : BLOCK_DB;\nEND_VAR\nBEGIN\nNETWORK\n L DBW 2;\n"
    "END_FUNCTION\n"                                  // 37
    "DATA_BLOCK DB 10 FB 1\nBEGIN\nEND_DATA_BLOCK\n"  // 40
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"       // 43
    " CALL FB 1, DB 10 (q := M 0.0, a := P#M 30.0 BYTE 4, t := T 5, io := MW 50, s := DB1.s);\n"
    " CALL FC 1 (b := DB 3);\n UC FC 2;\n"                                                 // 46
    " CALL SFC 20 (SRCBLK := P#M 20.0 BYTE 4, RET_VAL := MW 10, DSTBLK := DB1.d);\n"       // 47
    " CALL SFC 1 (RET_VAL := MW 10, CDT := DB1.d);\n"                                      // 48
    " AUF DB 3;\n L DBW 0;\n AUF DI 10;\n U DIX 0.0;\n U E 0.0;\n SPB far;\n AUF DB 1;\n"  // 55
    "far: T DBW 2;\nEND_ORGANIZATION_BLOCK\nFUNCTION FC 2 : "
    "VOID\nBEGIN\nNETWORK\nEND_FUNCTION\n";  // 56

struct Calls : ::testing::Test {
  Plc plc{kCalls};
  block::Program library = system::library(defaultCpuModel());
  std::vector<CrossReference> list =
      crossReferences(plc.program(), plc.symbols(), {.library = &library});
  std::string of(const std::string& filter) {
    const auto part = filtered(list, filter, plc.resolver());
    if (!part) return std::string(part.error().name());
    std::string result;
    for (const CrossReference& row : *part)
      result += row.operand + " " + std::string(monitor::name(row.use)) + " " +
                std::to_string(row.place.line) + "; ";
    return result;
  }
};

// S7-EDIT-22: data without its block, where the code says which one is open and where it does not.
TEST_F(Calls, DataOfTheOpenBlock) {
  EXPECT_EQ(of("DBW 0"), "P#DB1.DBX 0.0 BYTE 6 RW 44; DB3.DBW 0 R 50; DB10.DBX 0.0 R 52; ");
  EXPECT_EQ(of("DB3.DBW 0"), "DB3.DBW 0 R 50; ");
  EXPECT_EQ(of("dbb 3").substr(0, 25), "DBW 2 W 56; DBW 2 R 36; P");
  EXPECT_EQ(of("DIX 0.0"), of("DBX 0.0"));
  EXPECT_EQ(of("DBQ 0"), "P0317");
}

// S7-EDIT-22: ANY, blocks, timers and composite operands as actual parameters.
TEST_F(Calls, ActualParameters) {
  EXPECT_EQ(of("MB 21"), "P#M 20.0 BYTE 4 R 47; ");
  EXPECT_EQ(of("MB 24"), "");
  EXPECT_EQ(of("MB 33"), "P#M 30.0 BYTE 4 R 44; ");
  EXPECT_EQ(of("T 5"), "T 5 R 44; ");
  EXPECT_EQ(of("DB 3"), "DB3.DBW 0 R 50; DB 3 - 45; DB 3 - 49; ");
  EXPECT_EQ(of("DB1.d"), of("DB1.DBB 7"));
  EXPECT_EQ(of("DB1.DBB 7"), "P#DB1.DBX 6.0 DATE_AND_TIME 1 W 47; P#DB1.DBX 6.0 BYTE 8 W 48; ");
  const auto bytes = assignmentList(list).bytes;
  EXPECT_TRUE(std::ranges::any_of(bytes, [](const AssignmentByte& one) {
    return one.area == Area::Flag && one.byte == 23 && one.byByte;
  }));
}

// S7-EDIT-22: 12 bits are two bytes, also where they do not begin at one; the last counts.
TEST(Assignments, RangesCountEachByteTheyTouch) {
  const Plc plc(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
      " CALL SFC 20 (SRCBLK := P#M 20.0 BOOL 12, RET_VAL := MW 90, DSTBLK := P#A 4.0 BOOL 16);\n"
      " CALL SFC 20 (SRCBLK := P#M 30.0 BOOL 8, RET_VAL := MW 90, DSTBLK := P#E 3.4 BOOL 5);\n"
      "END_ORGANIZATION_BLOCK\n");
  const block::Program library = system::library(defaultCpuModel());
  std::string bytes;
  for (const AssignmentByte& one :
       assignmentList(crossReferences(plc.program(), plc.symbols(), {.library = &library})).bytes)
    bytes += std::to_string(static_cast<int>(one.area) & 7) + "." + std::to_string(one.byte) + " ";
  EXPECT_EQ(bytes, "1.3 1.4 2.4 2.5 3.20 3.21 3.30 3.90 3.91 ");
}

// S7-EDIT-22: a CALL is one statement of the source.
TEST_F(Calls, AreShownAsCalls) {
  EXPECT_EQ(of("MW 50"), "MW 50 RW 44; ");
  std::string text;
  for (const CrossReference& row : list)
    if (row.block && row.place.line <= 46) text += row.operand + ": " + row.instruction + "; ";
  EXPECT_EQ(text,
            "DB 3: CALL  FC 1; DB 10: CALL  FB 1, DB 10; "
            "FC 1: CALL  FC 1; FC 2: UC    FC 2; FB 1: CALL  FB 1, DB 10; ");
}

}  // namespace
}  // namespace merker::monitor::test
