// Terms of //= comments become codes that query or load.
#include "compile.h"

namespace merker::step5 {
namespace {

using block::CheckValue;

std::vector<block::Check> checksOf(const std::string& comment) {
  auto c = compileText("OB 1\n: L KB 1   //= " + comment + "\n: BE\n", true);
  return c.ok() ? c.program.at({mc5::BlockType::Ob, 1}).checks : std::vector<block::Check>{};
}

TEST(CheckComment, Terms) {
  const auto checks =
      checksOf("AKKU1 = KF -7, VKE = 1, M 1.0 = 0, DB10.DW 4 <> KH 00FF, T 1 = KT 10.2");
  ASSERT_EQ(checks.size(), 1u);
  const auto& terms = checks[0].terms;
  ASSERT_EQ(terms.size(), 5u);
  EXPECT_EQ(checks[0].offset, 0u);
  EXPECT_EQ(terms[0].left.width, 16u);
  EXPECT_EQ(terms[0].right.constant, 0xFFF9u);
  EXPECT_EQ(terms[2].left.kind, CheckValue::Kind::BitCode);
  EXPECT_EQ(terms[2].left.code, (std::vector<std::uint8_t>{0x80, 0x01}));
  EXPECT_EQ(terms[3].relation, block::Relation::NotEqual);
  EXPECT_EQ(terms[3].left.code, (std::vector<std::uint8_t>{0x20, 0x0A, 0x32, 0x04}));
  EXPECT_EQ(terms[4].left.code, (std::vector<std::uint8_t>{0x0C, 0x01}));  // LC T 1
}

// The first comma is that of the constant, the second one begins a term.
TEST(CheckComment, TwoBytesAreOneConstant) {
  for (const char* text : {"AKKU1 = KY 1,2, VKE = 0", "AKKU1 = KY 1, 2,VKE = 0"}) {
    const auto checks = checksOf(text);
    ASSERT_EQ(checks.size(), 1u) << text;
    ASSERT_EQ(checks[0].terms.size(), 2u) << text;
    EXPECT_EQ(checks[0].terms[0].right.constant, 0x102u) << text;
  }
}

TEST(CheckComment, ALineOfItsOwnBelongsToTheInstructionBefore) {
  const auto c = compileText("OB 1\n: L KB 1\n: L KB 2\n  //= AKKU2 = 1\n: BE\n", true);
  ASSERT_TRUE(c.ok());
  const auto& checks = c.program.at({mc5::BlockType::Ob, 1}).checks;
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_EQ(checks[0].offset, 1u);
  EXPECT_EQ(checks[0].position.line, 4u);
}

TEST(CheckComment, WrongTerms) {
  EXPECT_EQ(problemsOf("OB 1\n//= VKE = 1\n: BE\n", true), "P1143@2:1");
  EXPECT_EQ(problemsOf("OB 1\n: L KB 1 //= VKE\n: BE\n", true), "P1142@2:17");
  EXPECT_EQ(problemsOf("OB 1\n: L KB 1 //= QW 1 = 1\n: BE\n", true).substr(0, 5), "P1142");
  EXPECT_EQ(problemsOf("OB 1\n: L KB 1 //= VKE\n: BE\n", false), "");
}

}  // namespace
}  // namespace merker::step5
