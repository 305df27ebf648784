// What an edit is refused with, and its sentences.
#include "edits.h"

namespace merker::graph {
namespace {

using namespace edits;

std::string series(int contacts) {
  std::string out;
  for (int i = 0; i < contacts; ++i) out += "U E 0.0; ";
  return out + "= A 0.0";
}

constexpr const char* kSevenDeep =
    "U E 0.0; U(; X E 0.1; X(; U E 0.2; U(; X E 0.3; X(; U E 0.4; U(; X E 0.5; X(; U E 0.6; U(; "
    "X E 0.7; X E 1.0; ); ); ); ); ); ); ); = A 0.0";

TEST(Edit, SaysWhatCannotBe) {
  const std::string refused = "refused: ", timer = "U E 0.0; L S5T#2S; SE T 1; NOP; NOP; NOP; NOP";
  expectAll({
      {timer, act(Action::SetOperand, "6:9", "M 1.0"), refused + "the element has no such pin"},
      {timer, act(Action::SetOperand, "6:2", "M 1.0"), refused + "this operand cannot stand here"},
      {timer, act(Action::SetOperand, "6:0", "MW 1"), refused + "this operand cannot stand here"},
      {"U E 0.0; = A 0.0", act(Action::SetOperand, "1:0", "MW 1"),
       refused + "this operand cannot stand here"},
      {"U E 0.0; = A 0.0", insert("0", kBehind, "CONTACT", {"MW 1"}),
       refused + "this operand cannot stand here"},
      {"CALL FC 1; NOP", act(Action::SetOperand, "1:0", "BIE"),
       refused + "this operand cannot stand here"},
      {"", insert("", kBehind, "MOVE", {"", "M 1.0"}), refused + "this operand cannot stand here"},
      {"U E 0.0; U E 0.1; = A 0.0", insert("0", kBefore, "COIL"),
       refused + "a coil cannot stand here"},
      {"O E 0.0; O E 0.1; = A 0.0", insert("0", kBehind, "COIL"),
       refused + "a coil cannot stand here"},
      {"U E 0.0; U E 0.1; = A 0.0", act(Action::CloseBranch, "0"),
       refused + "the element stands in no branch that could be closed further right"},
      {"U(; O E 0.0; O E 0.1; ); = A 0.0", act(Action::CloseBranch, "1"),
       refused + "the element stands in no branch that could be closed further right"},
      {kSevenDeep, insert("14", kBehind, "CONTACT"),
       refused + "the network would be nested too deeply"},
      {series(3999), insert("0", kBehind, "CONTACT"), refused + "the network would be too large"},
  });
}

TEST(Edit, EveryProblemHasItsSentences) {
  for (int i = 0; i <= static_cast<int>(EditProblem::Ambiguous); ++i) {
    const auto problem = static_cast<EditProblem>(i);
    EXPECT_NE(text(problem, Language::German), text(problem, Language::English));
  }
}

TEST(Reasons, AreSaidInBothLanguages) {
  for (int i = 0; i <= static_cast<int>(Reason::Size); ++i) {
    const auto reason = static_cast<Reason>(i);
    EXPECT_NE(text(reason, Language::German), text(reason, Language::English));
  }
}

}  // namespace
}  // namespace merker::graph
