// What stands behind a statement: a comment, or something that must not be swallowed.
#include "compile.h"

namespace merker::step5 {
namespace {

std::string statement(const std::string& text) {
  return problemsOf("FB 1\nNAME : TEST\nBEZ : EIN E BI\n: " + text + "\n: BE\n");
}

// S5-STMT-01, S5-BIT-07: a damaged operand of O is no "AND before OR".
TEST(LineEnd, DamagedOperands) {
  EXPECT_EQ(statement("O M 5"), "P1107@4:8");
  EXPECT_EQ(statement("O E"), "P1106@4:6");
  EXPECT_EQ(statement("O E 1,2"), "P1107@4:8");
  EXPECT_EQ(statement("O"), "");
  EXPECT_EQ(statement("O E 1.2"), "");
  EXPECT_EQ(statement("O  oder so"), "");
}

// S5-STMT-01: one statement on a line.
TEST(LineEnd, ASecondStatement) {
  EXPECT_EQ(statement("U E 1.1 U E 1.3 = A 3.6"), "P1152@4:11");
  EXPECT_EQ(statement("U E 1.1 E 1.3"), "P1152@4:11");
  EXPECT_EQ(statement("BEB PB 3"), "P1152@4:7");
  EXPECT_EQ(statement("STP NOP"), "P1152@4:7");
  EXPECT_EQ(statement("TAK TAK"), "P1152@4:7");
  EXPECT_EQ(statement("+F T MW 30"), "P1152@4:6");
  EXPECT_EQ(statement("= A 3.6 = A 3.7"), "P1111@4:11");
}

// O without operand with a comment would be another operation.
TEST(LineEnd, AnOperandThatIsMissing) { EXPECT_EQ(statement("O ??.?"), "P1111@4:5"); }

// 6.3, 9.4.10, 9.4.11: comments without a mark as they are printed.
TEST(LineEnd, PrintedComments) {
  EXPECT_EQ(statement("T MB 254 ZIEL, DB-Nr. FB 61 KOMMANDO TOS"), "");
  EXPECT_EQ(statement("L DW7 KH=1010 Die Operationen I16 und D33 beeinflussen nur das"), "");
  EXPECT_EQ(statement("I 16 rechte Byte. Deshalb bleibt der Wert im linken Byte"), "");
  EXPECT_EQ(statement("T MW 177      (zur weiteren Verarbeitung)"), "");
  EXPECT_EQ(statement("= M 191.0          Datenschnittstelle nicht belegt (M 190.3)"), "");
  EXPECT_EQ(statement("U E 1.1 ! U E 1.3"), "");
}

// 6.3, FB 140: a comment goes on behind a colon, in its column.
TEST(LineEnd, ACommentGoesOn) {
  EXPECT_EQ(statement("                              wird im MW 241 abgelegt."), "");
  EXPECT_EQ(statement("                              U E 1.8"), "P1112@4:35");
  EXPECT_EQ(statement("wird im MW 241 abgelegt."), "P1103@4:3");
}

// S5-CMP-05, OP-34: blanks within the sign, and "=>".
TEST(LineEnd, SignsOfComparison) {
  const auto code = [](const std::string& text) {
    return words(compileText("PB 1\n: " + text + "\n: BE\n"), mc5::BlockType::Pb, 1).at(0);
  };
  EXPECT_EQ(code("> D"), 0x3920);
  EXPECT_EQ(code("< D"), 0x3940);
  EXPECT_EQ(code("<= G"), 0x31C0);
  EXPECT_EQ(code("> = F"), 0x21A0);
  EXPECT_EQ(code("> <F"), 0x2160);
  EXPECT_EQ(code("=>G"), 0x31A0);
  EXPECT_EQ(problemsOf("PB 1\n: =>G\n: BE\n"), "P1151@2:3");
  EXPECT_EQ(problemsOf("PB 1\n: = D 9.15\n: BE\n"), "");
}

// Word addresses in front, as programmers print them.
TEST(LineEnd, Addresses) {
  const auto c =
      compileText("FB 1\n0000   : U E 0.1\n 0001 : SPB =M2\n 0002   M2 : = A 0.2\n0003 :BE\n");
  EXPECT_TRUE(c.ok());
  EXPECT_EQ(words(c, mc5::BlockType::Fb, 1),
            (std::vector<std::uint16_t>{0xC100, 0xFA01, 0xDA80, 0x6500}));
}

}  // namespace
}  // namespace merker::step5
