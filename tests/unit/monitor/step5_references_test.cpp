#include "listing.h"
#include "monitor/assignment_list.h"
#include "step5/variable.h"

namespace merker::monitor::test {
namespace {

const char* const kListing =
    "OB 1\n"
    "NETZWERK 1\n"
    " : U   E 0.0\n"  // 3
    " : =   A 0.1\n"
    " : A   DB 10\n"
    " : SPA FB 5\n"  // 6
    "NAME : VENTIL\n"
    "AUF  : E 1.0\n"
    "LAMP : A 2.0\n"
    "ZEIT : T 3\n"
    "WERT : DW 7\n"
    "K    : KF +5\n"
    "NETZWERK 2\n"
    " : L   MW 10\n"  // 14
    " : T   DW 2\n"
    " : SPA PB 5\n"
    " : L   DR 2\n"  // 17
    " : SPA FB 6\n"
    "NAME : WAHL\n"
    "DBX  : DB 20\n"
    "WERT : DW 8\n"
    " : BE\n"  // 22
    "PB 5\n"
    " : A   DB 11\n"
    " : L   DL 3\n"  // 25
    " : L   PB 5\n"
    " : ZV  Z 4\n"
    " : BE\n"
    "FB 5\n"
    "NAME : VENTIL\n"
    "BEZ  : AUF   E/A/D/B/T/Z: E  BI/BY/W/D: BI\n"
    "BEZ  : LAMP  E/A/D/B/T/Z: A  BI/BY/W/D: BI\n"
    "BEZ  : ZEIT  E/A/D/B/T/Z: T\n"
    "BEZ  : WERT  E/A/D/B/T/Z: E  BI/BY/W/D: W\n"
    "BEZ  : K     E/A/D/B/T/Z: D  KM/KH/KY/KC/KT/KZ/KG/: KF\n"
    " : U   =AUF\n"  // 36
    " : UN  =LAMP\n"
    " : =   =LAMP\n"
    " : L   KT 010.1\n"
    " : SI  =ZEIT\n"  // 40
    " : L   =WERT\n"
    " : LW  =K\n"
    " : SU  M 5.0\n"
    " : P   T 3.15\n"
    " : BE\n"  // 45
    "FB 6\n"
    "NAME : WAHL\n"
    "BEZ  : DBX   E/A/D/B/T/Z: B\n"
    "BEZ  : WERT  E/A/D/B/T/Z: E  BI/BY/W/D: W\n"
    " : A   DB 12\n"  // 50
    " : L   DW 1\n"
    " : B   =DBX\n"
    " : L   DW 0\n"  // 53
    " : L   =WERT\n"
    " : A   DB 13\n"
    " : B   MW 20\n"  // 56
    " : L   MW 0\n"
    " : B   DW 4\n"
    " : A   DB 0\n"
    " : L   DW 6\n"  // 60
    " : A   DB 14\n"
    " : U   M 6.0\n"
    " : SPB =M001\n"
    " : A   DB 15\n"
    "M001 : T DW 9\n"  // 65
    " : BE\n";

struct Step5Uses : ::testing::Test {
  mc5::Program program = listing(kListing);
  source::SymbolTable symbols;
  std::vector<CrossReference> list = crossReferences(program, symbols);

  static std::string text(const std::vector<CrossReference>& rows) {
    std::string result;
    for (const CrossReference& row : rows)
      result += row.operand + " " + std::string(monitor::name(row.use)) + " " +
                std::to_string(row.place.line) + "; ";
    return result;
  }
  std::string of(const std::string& filter) {
    const auto resolver = [](std::string_view what,
                             const Position& at) -> Result<address::Reference> {
      if (const auto variable = step5::parseVariable(what)) return *variable;
      return makeProblem(ProblemCode::P1104, at, std::string(what));
    };
    const auto part = filtered(list, filter, {resolver, {}, true}, step5Words(), symbols);
    return part ? text(*part) : std::string(part.error().name());
  }
};

// Every use with its place, in the order of the list.
TEST_F(Step5Uses, AreListed) {
  EXPECT_EQ(
      text(list),
      "E 0.0 R 3; E 1.0 R 6; A 0.1 W 4; A 2.0 RW 6; M 5.0 W 43; M 6.0 R 62; MW 10 R 14; "
      "MW 20 R 56; PB 5 R 26; T 3.15 R 44; T 3 W 6; Z 4 W 27; "
      "DW 0 R 53; DW 6 R 60; DW 8 R 18; DW 9 W 65; DB10.DW 2 W 15; DB10.DR 2 R 17; DB10.DW 7 R 6; "
      "DB11.DL 3 R 25; DB12.DW 1 R 51; DB13.DW 4 R 58; "
      "PB 5 - 16; DB 10 - 5; DB 11 - 24; DB 12 - 50; DB 13 - 55; DB 14 - 61; DB 15 - 64; "
      "DB 20 - 18; FB 5 - 6; FB 6 - 18; "
      "=AUF R 36; =LAMP R 37; =LAMP W 38; =ZEIT W 40; =WERT R 41; =K R 42; =DBX - 52; "
      "=WERT R 54; ");
  EXPECT_EQ(list[0].instruction, "U     E 0.0");
  EXPECT_EQ(list[1].instruction, "SPA   FB 5");
  EXPECT_EQ(list[1].statement, 4u);
  EXPECT_EQ(list[6].place.network, 2u);
  EXPECT_EQ(list[6].statement, 1u);
  EXPECT_EQ(list.back().instruction, "L     =WERT");
}

// S5-DB-07: after a return the data block of the caller is open again. S5-PROC-01: what B replaces
// is not used, and which block A opens behind it is not known; nor is it where a jump arrives.
TEST_F(Step5Uses, DataOfTheOpenBlock) {
  EXPECT_EQ(of("DB10.DW 2"), "DB10.DW 2 W 15; DB10.DR 2 R 17; ");
  EXPECT_EQ(of("DL 2"), "DB10.DW 2 W 15; ");
  EXPECT_EQ(of("D 2.0"), "DB10.DW 2 W 15; DB10.DR 2 R 17; ");
  EXPECT_EQ(of("DW 6, DW 9, DW 0"), "DW 0 R 53; DW 6 R 60; DW 9 W 65; ");
  EXPECT_EQ(of("MW 0"), "");
  EXPECT_EQ(of("DB 0"), "");
}

TEST_F(Step5Uses, CanBeFiltered) {
  EXPECT_EQ(of("MB 11, e"), "E 0.0 R 3; E 1.0 R 6; MW 10 R 14; ");
  EXPECT_EQ(of("PB 5"), "PB 5 R 26; PB 5 - 16; ");
  EXPECT_EQ(of("PY 5"), "PB 5 R 26; ");
  EXPECT_EQ(of("PB"), "PB 5 - 16; ");
  EXPECT_EQ(of("T 3"), "T 3.15 R 44; T 3 W 6; ");
  EXPECT_EQ(of("DB 10"), "DB10.DW 2 W 15; DB10.DR 2 R 17; DB10.DW 7 R 6; DB 10 - 5; ");
  EXPECT_EQ(of("FB"), "FB 5 - 6; FB 6 - 18; ");
  EXPECT_EQ(of("=wert"), "=WERT R 41; =WERT R 54; ");
  EXPECT_EQ(of("FC 1"), "P1104");
}

TEST_F(Step5Uses, HaveSymbols) {
  Problems problems;
  source::readSymbols(source::SourceFile("press.sym",
                                         "\"Start\" E 0.0 BOOL\n\"Valve\" FB 5\n"
                                         "\"Spare\" E 7.7 BOOL\n"),
                      symbols, problems);
  list = crossReferences(program, symbols);
  EXPECT_EQ(list[0].symbol, "Start");
  const auto unused = unusedSymbols(list, symbols);
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_EQ(unused[0].name, "Spare");
  const std::vector<std::string> without = operandsWithoutSymbol(list);
  EXPECT_EQ(without.front(), "E 1.0");
  EXPECT_EQ(without.back(), "Z 4");
}

// A datum has the same name in each block, a block that of its call and of its data.
TEST_F(Step5Uses, AreFoundByTheirNames) {
  symbols = source::SymbolTable(source::Language::Step5);
  Problems problems;
  source::readSymbols(
      source::SourceFile("pressZ0.seq",
                         "\tPB 5\tPUMPE\r\n\tDB 10\tDATEN\r\n\tDW 2\tANZAHL\r\n\tDW 99\tLEER\r\n"),
      symbols, problems);
  EXPECT_TRUE(problems.empty());
  list = crossReferences(program, symbols);
  EXPECT_EQ(of("-PUMPE"), "PB 5 - 16; ");
  EXPECT_EQ(of("\"PUMPE\""), "PB 5 - 16; ");
  EXPECT_EQ(of("-DATEN"), of("DB 10"));
  EXPECT_EQ(of("-ANZAHL"), "DB10.DW 2 W 15; DB10.DR 2 R 17; ");
  EXPECT_EQ(of("-NICHTS"), "P1104");
  const auto unused = unusedSymbols(list, symbols);
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_EQ(unused[0].name, "LEER");
}

TEST_F(Step5Uses, MakeTheAssignmentList) {
  const AssignmentList assignment = assignmentList(list);
  EXPECT_EQ(assignment.timers, std::vector<std::uint32_t>{3});
  EXPECT_EQ(assignment.counters, std::vector<std::uint32_t>{4});
  std::string bytes;
  for (const AssignmentByte& one : assignment.bytes)
    bytes += std::to_string(static_cast<int>(one.area) & 7) + "." + std::to_string(one.byte) +
             (one.byWord ? "W " : " ");
  EXPECT_EQ(bytes, "1.0 1.1 2.0 2.2 3.5 3.6 3.10W 3.11W 3.20W 3.21W ");
}

// Without knowing its code: what the declaration of a macro says.
TEST(Step5Macros, UseTheirActualOperands) {
  const mc5::Program program = listing(
      "OB 1\n : SPA FB 190\nNAME : K-LEITPC\nADPR : KF +1\nDBDW : KY 10,1\nR/A  : KY 0,0\n"
      "MELD : MB 8\n : BE\n");
  std::string text;
  for (const CrossReference& row : crossReferences(program, {}))
    text += row.operand + " " + std::string(name(row.use)) + "; ";
  EXPECT_EQ(text, "MB 8 W; FB 190 -; ");
}

// A computed jump may arrive anywhere: no data block is known in such a block.
TEST(Step5Jumps, ThatAreComputedHideTheDataBlock) {
  const mc5::Program program =
      listing("FB 1\nNAME : SPRUNG\n : A DB 10\n : B MW 0\n : SPA =M001\nM001 : L DW 1\n : BE\n");
  std::string text;
  for (const CrossReference& row : crossReferences(program, {})) text += row.operand + "; ";
  EXPECT_EQ(text, "MW 0; DW 1; DB 10; ");
}

// Whatever a block contains: no word leads out of it or around in it.
TEST(Step5Code, OfAnyWordsIsRead) {
  mc5::Block block;
  block.id = {mc5::BlockType::Fb, 1};
  block.parameters = {{"A", mc5::ParameterKind::Input}, {"B", mc5::ParameterKind::Block}};
  for (std::uint32_t word = 0; word <= 0xFFFF; ++word) {
    const auto first = static_cast<std::uint16_t>(word);
    block.words = {first, first, 0x3D01, 0x2D03, first, first, first};  // SPA FB 1 with its list
    const mc5::Program program{{block.id, block}};
    for (const CrossReference& row : crossReferences(program, {})) {
      EXPECT_LT(row.place.offset, block.words.size()) << word;
      EXPECT_FALSE(row.operand.empty()) << word;
    }
    for (std::uint32_t offset = 0; offset < block.words.size(); ++offset)
      EXPECT_LE(BlockCode(block).instructionAt(offset), offset) << word;
  }
}

}  // namespace
}  // namespace merker::monitor::test
