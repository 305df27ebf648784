// Assignment lists of STEP 5 (docs/formats/symbols.md).
#include <gtest/gtest.h>

#include "source/symbol_table.h"
#include "source/symbol_text.h"

namespace merker::source {
namespace {

struct List {
  SymbolTable table{Language::Step5};
  Problems problems;
  explicit List(const std::string& text) {
    readSymbols(SourceFile("PUMPEZ0.SEQ", text), table, problems);
  }
  // "MOTOR=A 1.0 (Antrieb)"
  std::string row(std::size_t i) const {
    const Symbol& s = table.list().at(i);
    const std::string operand(operandName(s.address, Mnemonics::German, Language::Step5));
    return s.name + "=" + operand + " " + operandNumber(s.address) + " (" + s.comment + ")";
  }
};

SymbolAddress at(const char* text) { return *parseSymbolAddress(text, {}, Language::Step5); }

TEST(AssignmentList, OperandsOfStep5ComeBackAsTheyWereWritten) {
  for (const char* text :
       {"E 1.0",  "EB 2",   "EW 4",   "ED 6",   "A 127.7", "AB 1",  "AW 2",  "AD 4",
        "M 10.5", "MB 255", "MW 20",  "MD 22",  "D 7.15",  "D 7.8", "D 7.7", "D 0.0",
        "DL 7",   "DR 7",   "DW 255", "DD 3",   "PY 4",    "PW 6",  "T 31",  "Z 5",
        "OB 1",   "PB 5",   "SB 7",   "FB 190", "DB 20"}) {
    const SymbolAddress address = at(text);
    EXPECT_EQ(std::string(operandName(address, Mnemonics::German, Language::Step5)) + " " +
                  operandNumber(address),
              text);
  }
}

TEST(AssignmentList, OperandsHaveTheNamesOfTheEnglishEdition) {
  EXPECT_EQ(at("I 1.0"), at("E 1.0"));
  EXPECT_EQ(at("Q 1.0"), at("A 1.0"));
  EXPECT_EQ(at("F 1.0"), at("M 1.0"));
  EXPECT_EQ(at("FY 1"), at("MB 1"));
  EXPECT_EQ(at("C 5"), at("Z 5"));
}

TEST(AssignmentList, ProgramBlockAndPeripheryByteDiffer) {
  EXPECT_EQ(at("PB 5").block, (BlockId{BlockKind::PB, 5}));
  EXPECT_EQ(at("PY 5").area, Area::Peripheral);
  EXPECT_FALSE(parseSymbolAddress("PB 5", {}).has_value());  // STEP 7 has none
  EXPECT_FALSE(parseSymbolAddress("FC 5", {}, Language::Step5).has_value());
  EXPECT_FALSE(parseSymbolAddress("D 5.16", {}, Language::Step5).has_value());
  EXPECT_FALSE(parseSymbolAddress("E 5.8", {}, Language::Step5).has_value());
}

TEST(AssignmentList, IsReadWithTabs) {
  const List list(
      "; Pumpe 1\r\n\tE 1.0\tTASTER\tEin\r\n\tA  1.0\tMOTOR\r\n*\tPB 5\tPUMPE\tFolge\r\n"
      "DB20\tDATEN\t\r\n\tM 1.0\t\tohne Symbol\r\n");
  ASSERT_EQ(list.problems.size(), 0u);
  ASSERT_EQ(list.table.list().size(), 4u);
  EXPECT_EQ(list.row(0), "TASTER=E 1.0 (Ein)");
  EXPECT_EQ(list.row(1), "MOTOR=A 1.0 ()");
  EXPECT_EQ(list.row(2), "PUMPE=PB 5 (Folge)");
  EXPECT_EQ(list.row(3), "DATEN=DB 20 ()");
}

TEST(AssignmentList, IsReadInFixedColumns) {
  const List list(
      "  E 1.0     TASTER    Ein Taster\r\n  E   1.1   STOP\r\n  DW 12     SOLL      Sollwert\r\n");
  ASSERT_EQ(list.problems.size(), 0u);
  ASSERT_EQ(list.table.list().size(), 3u);
  EXPECT_EQ(list.row(0), "TASTER=E 1.0 (Ein Taster)");
  EXPECT_EQ(list.row(1), "STOP=E 1.1 ()");
  EXPECT_EQ(list.row(2), "SOLL=DW 12 (Sollwert)");
}

TEST(AssignmentList, WrongLinesAreReported) {
  const List list("\tE 1.0\tMOTOR\n\tE 1.1\tmotor\n\tFX 3\tFEIN\n\tE 1.8\tBIT\n");
  std::string reported;
  for (const Problem& p : list.problems.list())
    reported += std::string(p.name()) + "@" + std::to_string(p.position.line) + ":" +
                std::to_string(p.position.column) + " ";
  EXPECT_EQ(reported, "P0807@2:8 P1104@3:2 P0805@4:2 ");
}

TEST(AssignmentList, IsWrittenInACodePageOfDos) {
  const List list("\tA 1.0\tGERÄT\tgrün\n\tPY 3\tWAAGE\tkg\n");
  EXPECT_EQ(writeSymbols(list.table, ".seq", Mnemonics::German),
            "\tA 1.0\tGER\x8ET\tgr\x81n\r\n\tPY 3\tWAAGE\tkg\r\n");
}

TEST(AssignmentList, APeripheryByteHasOneSymbolForBothDirections) {
  const List list("\tPY 3\tWAAGE\n");
  SymbolAddress written = at("PY 3");
  written.peripheralOutput = true;
  ASSERT_NE(list.table.findAddress(written), nullptr);
  EXPECT_EQ(list.table.findAddress(written), list.table.findAddress(at("PY 3")));
}

}  // namespace
}  // namespace merker::source
