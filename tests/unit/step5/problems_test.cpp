// What is wrong with a listing is told at its place, all of it in one pass.
#include "compile.h"

namespace merker::step5 {
namespace {

// S5-BLK-03, S5-BLK-04, S5-BLK-05, S5-BLK-11, S5-BLK-12, S5-DB-05, S5-JUMP-03, S5-BIT-10,
// S5-SHIFT-05
TEST(Problems, OfStatements) {
  EXPECT_EQ(problemsOf("OB 1\n: SLW 4\n: BE\n"), "P1113@2:3");
  EXPECT_EQ(problemsOf("PB 1\n: SRD 4\n: L DW 256\n: U E 128.0\n: U E 0.8\n: BE\n"),
            "P1103@2:3 P1112@3:5 P1112@4:5 P1112@5:5");
  EXPECT_EQ(problemsOf("OB 1\n: U E 0.0\n"), "P1121@1:1");
  EXPECT_EQ(problemsOf("OB 1\n: BE\n: U E 0.0\n"), "P1122@3:3");
  EXPECT_EQ(problemsOf("FB 1\n: SPA =WEG\n: BE\n"), "P1115@2:8");
  EXPECT_EQ(problemsOf("FB 1\nA1 : NOP 0\nA1 : BE\n"), "P1116@3:1");
  EXPECT_EQ(problemsOf("FB 1\nNETZWERK 1\n: SPA =ZIEL\nNETZWERK 2\nZIEL : BE\n"), "P1118@3:8");
  EXPECT_EQ(problemsOf("PB 1\n: U(\n: O E 0.0\n: BE\n"), "P1138@2:3");
  EXPECT_EQ(problemsOf("PB 1\n: )\n: BE\n"), "P1137@2:3");
  EXPECT_EQ(problemsOf("OB 64\n: BE\n"), "P1102@1:1");
  EXPECT_EQ(problemsOf("DB 0\n KH 0\n"), "P1102@1:1");
  EXPECT_EQ(problemsOf("OB 1\n: SPA OB 20\n: BE\n"), "P1139@2:7");
  EXPECT_EQ(problemsOf("PB 1\n: BE\nPB 1\n: BE\n"), "P1120@3:1");
  EXPECT_EQ(problemsOf("OB 1\n: = M 12.0\n: BE\n"), "P1135@2:5");
}

TEST(Problems, NamesHaveALength) {
  EXPECT_EQ(problemsOf("FB 5\nNAME : ACHTSTEL\n: BE\n"), "");
  EXPECT_EQ(problemsOf("FB 5\nNAME : NEUNSTELL\n: BE\n"), "P1119@2:8");
}

TEST(Problems, CoverTheWholeOperand) {
  const auto c = compileText("OB 1\n: U MW 100\n: BE\n");
  ASSERT_EQ(c.problems.size(), 1u);
  EXPECT_EQ(c.problems.list()[0].code, ProblemCode::P1109);
  EXPECT_EQ(c.problems.list()[0].position, (Position{"t.s5", 2, 5, 6}));
}

TEST(Problems, AJumpReaches127Words) {
  std::string text = "FB 1\n: SPA =ZIEL\n";
  for (int i = 0; i < 126; ++i) text += ": NOP 0\n";
  EXPECT_EQ(problemsOf(text + "ZIEL : BE\n"), "");
  EXPECT_EQ(problemsOf(text + ": NOP 0\nZIEL : BE\n"), "P1117@2:8");
}

constexpr const char* kFb = "FB 5\nNAME : TEST\nBEZ : EIN E BI\nBEZ : WERT D KF\n: BE\n";

// S5-FB-04, S5-FB-05, S5-FB-08, S5-FB-09, S5-FB-10, S5-FB-11, S5-FB-13, S5-FB-20
TEST(Problems, OfCallsAndDeclarations) {
  const std::string fb = kFb;
  EXPECT_EQ(problemsOf(fb + "OB 1\n: SPA FB 5\nEIN : E 0.0\nWERT : KF 5\n: BE\n"), "");
  EXPECT_EQ(problemsOf(fb + "OB 1\n: SPA FB 5\nEIN : E 0.0\n: BE\n"), "P1125@7:7");
  EXPECT_EQ(problemsOf(fb + "OB 1\n: SPA FB 5\nWERT : KF 5\nEIN : E 0.0\n: BE\n"),
            "P1124@8:1 P1126@8:8 P1124@9:1 P1126@9:7");
  EXPECT_EQ(problemsOf(fb + "OB 1\n: SPA FB 5\nEIN : D 1.0\nWERT : KH 5\n: BE\n"),
            "P1126@8:7 P1126@9:8");
  EXPECT_EQ(problemsOf("OB 1\n: SPA FB 99\nNAME : X\nEIN : E 0.0\n: U E 0.0\n: BE\n"), "P1123@2:7");
  EXPECT_EQ(problemsOf("FB 60\n: BE\n"), "P1127@1:1");
  EXPECT_EQ(problemsOf("FB 1\nBEZ : ABCDE E BI\nBEZ : X Q\nBEZ : Y E KF\n: BE\n"),
            "P1119@2:7 P1128@3:9 P1129@4:11");
  EXPECT_EQ(problemsOf("FB 1\nBEZ : 1ABC E BI\nBEZ : ABCD E BI\n: BE\n"), "P1147@2:7");
  EXPECT_EQ(problemsOf("FB 1\nBEZ : X E BI\nBEZ : X E BI\n: U =Y\n: BE\n"), "P1140@3:7 P1114@4:6");
}

// S5-FB-14: B =X has no parameter list, so the block behind it must not need one.
TEST(Problems, ABlockAsParameterHasNoParameters) {
  const std::string callee = "FB 4\nNAME : LEER\n: BE\nPB 7\n: BE\n";
  const std::string caller = "FB 6\nNAME : RUFT\nBEZ : BST B\n: B =BST\n: BE\n";
  const auto call = [&](const char* block) {
    return problemsOf("OB 1\n: SPA FB 6\nBST : " + std::string(block) + "\n: BE\n" + kFb + callee +
                      caller);
  };
  EXPECT_EQ(call("FB 4"), "");
  EXPECT_EQ(call("PB 7"), "");
  EXPECT_EQ(call("FB 5"), "P1141@3:7");
  EXPECT_EQ(call("FB 61"), "P1141@3:7");
}

// S5-FLAG-12: what the system writes is for reading; MB 25 is the first free byte.
TEST(Problems, WritingFlagsOfTheSystemIsAWarning) {
  EXPECT_EQ(problemsOf("PB 1\n: = M 24.7\n: S M 25.0\n: U M 0.1\n: T MB 0\n: L MW 12\n: BE\n"),
            "P1135@2:5 P1135@5:5");
  EXPECT_FALSE(compileText("PB 1\n: = M 24.7\n: BE\n").problems.hasErrors());
}

// S5-DB-01, S5-DB-02
TEST(Problems, OfData) {
  EXPECT_EQ(problemsOf("DB 10\n0: KH 0\n2: KH 0\n"), "P1132@3:1");
  EXPECT_EQ(problemsOf("DB 10\n0: XY 0\n"), "P1131@2:1");
  EXPECT_EQ(problemsOf("DB 10\n0: KF 70000\n"), "P1108@2:4");
  std::string text = "DB 10\n";
  for (int i = 0; i < 2048; ++i) text += "KH 0\n";
  EXPECT_EQ(problemsOf(text), "");
  EXPECT_EQ(problemsOf(text + "KH 0\n"), "P1133@1:1");
}

TEST(Problems, TextThatIsNoListing) {
  EXPECT_EQ(problemsOf("hello\nworld\n"), "P1101@1:1");
  EXPECT_EQ(problemsOf(""), "P0104@0:0");
  EXPECT_EQ(problemsOf("OB 1\n: \x01\x02\n: BE\n"), "P1103@2:3");
}

}  // namespace
}  // namespace merker::step5
