// //= comments: where they belong to and what they compare (command line contract).
#include <gtest/gtest.h>

#include "mc7/disassembly.h"
#include "support.h"

namespace merker::step7 {
namespace {

const std::vector<block::Check>& checks(const Compiled& compiled) {
  return compiled.block(BlockKind::OB, 1).checks;
}

Compiled ob(std::string_view code) {
  return compileText(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\n" + std::string(code) + "\nEND_ORGANIZATION_BLOCK\n",
      "generic", true);
}

TEST(Check, BelongsToTheLastInstructionBefore) {
  const Compiled compiled =
      ob("L 1; L 2 //= AKKU1 = 2\n+I\n// nothing\n//= AKKU1 = 3, VKE=0\nCALL SFC 46\n");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  ASSERT_EQ(checks(compiled).size(), 2u);
  EXPECT_EQ(checks(compiled)[0].offset, 4u);
  EXPECT_EQ(checks(compiled)[1].offset, 8u);
  EXPECT_EQ(checks(compiled)[1].terms.size(), 2u);
  EXPECT_EQ(checks(compiled)[1].position.line, 6u);
}

TEST(Check, ReadsOperandsThroughMachineCode) {
  const Compiled compiled =
      ob("SET //= M 1.0 = 0, MW 10 <> W#16#5, T 1 = 1, T 1 = S5T#1S, Z 1 = 25, Z 1 = C#25, MD 4 ~= "
         "1.5, DB2.DBW 4 >= AKKU2");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  std::string text;
  for (const block::CheckTerm& term : checks(compiled)[0].terms)
    for (const mc7::Line& line : mc7::disassemble(term.left.code, Mnemonics::German))
      text += line.text + "|";
  EXPECT_EQ(text,
            "U     M 1.0|L     MW 10|U     T 1|LC    T 1|L     Z 1|LC    Z 1|L     MD 4|AUF   DB "
            "2|L     DBW 4|");
}

TEST(Check, LargeNumbersAndRegisters) {
  const Compiled compiled =
      ob("SET //= AKKU1 = 40000, STW = W#16#102, A1 = 0, A 1.0 = 1, RLO = 1, AKKU2 = -5");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_EQ(checks(compiled)[0].terms[0].right.constant, 40000u);
  EXPECT_EQ(checks(compiled)[0].terms[3].left.kind, block::CheckValue::Kind::BitCode);
  EXPECT_EQ(checks(compiled)[0].terms[5].right.constant, 0xFFFBu);
}

TEST(Check, BadTermsAreProblems) {
  EXPECT_EQ(ob("//= AKKU1 = 1\nSET //= AKKU1\nSET //= AKKU1 = nothing").problems(),
            (std::vector<std::string>{"3:4 P0901", "4:14 P0902", "5:17 P0317"}));
}

TEST(Check, SeparatorsAreNoChecks) {
  EXPECT_EQ(ob("//=========\nSET //== not one either").problems(), std::vector<std::string>{});
}

TEST(Check, ChangesNothingForOtherCommands) {
  const Compiled compiled =
      compileText("ORGANIZATION_BLOCK OB 1\nBEGIN\nSET //= rubbish\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_TRUE(checks(compiled).empty());
}

}  // namespace
}  // namespace merker::step7
