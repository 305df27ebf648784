#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

TEST(Instruction, OneListingPerForm) {
  const std::pair<const char*, const char*> cases[] = {
      {"U E 0.0", "U     E 0.0\n"},
      {"U(; O M1.2; )", "U(\nO     M 1.2\n)\n"},
      {"U( O M1.2\n)", "U(\nO     M 1.2\n)\n"},
      {"O", "O\n"},
      {"=A4.7", "=     A 4.7\n"},
      {"NOP 0; NOP 1; RND-; RND+", "NOP 0\nNOP 1\nRND-\nRND+\n"},
      {"+I; -D; *R; /I; ==I; <>D; >=R; <I", "+I\n-D\n*R\n/I\n==I\n<>D\n>=R\n<I\n"},
      {"+ 5; + L#-1; +AR1; +AR2 P#2.0", "+     5\n+     L#-1\n+AR1\n+AR2  P#2.0\n"},
      {"L -5; L C# 100; L P#M 10.0; L B#(1, 2)",
       "L     -5\nL     C#100\nL     P#M10.0\nL     B#(1,2)\n"},
      {"L DB5.DBW 2; T DB 6.DBD 4", "AUF   DB 5\nL     DBW 2\nAUF   DB 6\nT     DBD 4\n"},
      {"U E [MD 4]; T MW[DBD 8]; L W [AR1,P#2.0]; = [AR2, P#0.7]; S A [AR1,P#1.1]",
       "U     E [MD 4]\nT     MW [DBD 8]\nL     W [AR1,P#2.0]\n=     [AR2,P#0.7]\nS     A "
       "[AR1,P#1.1]\n"},
      {"AUF DB [MW 2]; AUF DI 3; UC FC [LW 30]; SE T [MW 4]; U Z [MW 6]",
       "AUF   DB [MW 2]\nAUF   DI 3\nUC    FC [LW 30]\nSPA   2\nSE    T [MW 4]\nU     Z [MW 6]\n"},
      {"L STW; T STW; L DBLG; L DINO; LAR1 AR2; LAR1 P#M 1.0; TAR2 MD 4",
       "L     STW\nT     STW\nL     DBLG\nL     DINO\nLAR1  AR2\nLAR1  P#M1.0\nTAR2  MD 4\n"},
      {"U ==0; UN >0; O OV; X BIE; ON UO", "U     ==0\nUN    >0\nO     OV\nX     BIE\nON    UO\n"},
      {"UW W#16#FF; UW; XOD DW#16#1; SLW 15; SRD; INC 255",
       "UW    W#16#00FF\nUW\nXOD   DW#16#00000001\nSLW   15\nSRD\nINC   255\n"},
      {"M001: U E 0.0; SPB M001; LOOP M001", "U     E 0.0\nSPB   -1\nLOOP  -3\n"},
      {"SPL m; SPA a; SPA b; m: SPA e; a: NOP 0; b: NOP 0; e: NOP 1",
       "SPL   2\nSPA   6\nSPA   5\nSPA   4\nNOP 0\nNOP 0\nNOP 1\n"},
      {"MCRA; MCR(; )MCR; MCRD", "MCRA\nMCR(\n)MCR\nMCRD\n"},
      {"L 'AB'; L 'abcd'; L S5T#5S; L T#1S; L D#1998-04-14; L TOD#1:2:3; L 1.5",
       "L     'AB'\nL     'abcd'\nL     S5T#5S\nL     T#1S\nL     D#1998-04-14\nL     "
       "TOD#01:02:03.000\nL     1.500000e+000\n"},
      {"// nothing\n (* a comment *) SET (* another *) ; // end", "SET\n"},
  };
  for (const auto& [source, expected] : cases) EXPECT_EQ(statements(source), expected) << source;
}

// MC7 section 10: the short form wherever it fits.
TEST(Instruction, TakesTheShortestCode) {
  const Compiled compiled = compileText(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nU M 255.7; U E 127.0; L MB 3; T AW 4; L T 5; UC FB 200\n"
      "END_ORGANIZATION_BLOCK\nFUNCTION_BLOCK FB 200\nBEGIN\nEND_FUNCTION_BLOCK\n",
      "generic");
  const std::vector<std::uint8_t> expected{0x87, 0xFF, 0xC0, 0x7F, 0x0A, 3,    0x53,
                                           0x84, 2,    5,    0x75, 200,  0x65, 0};
  EXPECT_EQ(compiled.block(BlockKind::OB, 1).code, expected);
}

// Whatever the source ends with (code patterns, section 5).
TEST(Instruction, BlockEndsWithBe) {
  const Compiled compiled = compileText(
      "FUNCTION FC 1 : VOID\nBEGIN\nBE;\nEND_FUNCTION\nFUNCTION FC 2 : VOID\nEND_FUNCTION\n");
  EXPECT_EQ(compiled.listing(BlockKind::FC, 1), "BE\nBE\n");
  EXPECT_EQ(compiled.listing(BlockKind::FC, 2), "BE\n");
}

TEST(Instruction, NetworksLinesAndTitles) {
  const Compiled compiled = compileText(
      "ORGANIZATION_BLOCK OB 1\nTITLE = Main\n// first line\n// second\nBEGIN\nNETWORK\nTITLE = "
      "one (\n SET\nNETWORK\n CLR;\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(compiled.problems(), std::vector<std::string>{});
  const block::Block& block = compiled.block(BlockKind::OB, 1);
  EXPECT_EQ(block.attributes.title, "Main");
  EXPECT_EQ(block.attributes.comment, "first line\nsecond");
  ASSERT_EQ(block.networks.size(), 2u);
  EXPECT_EQ(block.networks[0].title, "one (");
  EXPECT_EQ(block.networks[1].offset, 2u);
  EXPECT_EQ(block.line(0), 8u);
  EXPECT_EQ(block.line(2), 10u);
}

}  // namespace
}  // namespace merker::step7
