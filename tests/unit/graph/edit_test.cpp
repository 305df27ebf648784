// Elements put in, changed and taken out: each row is a network, an edit, and what it is then.
#include "graph/edit.h"

#include <gtest/gtest.h>

#include "edits.h"
#include "graph/locate.h"
#include "graph/missing.h"
#include "graph5/rules.h"
#include "graph7/rules.h"

namespace merker::graph {
namespace {

using namespace edits;

// S7-EDIT-08, S7-EDIT-14: U E 0.0; U E 0.1; O; U A 1.0; = A 3.0 from an empty network.
TEST(Edit, DrawsALatchFromNothing) {
  expectAll({
      {"", insert("", kBehind, "CONTACT"), "U ??.? [0:0]"},
      {"U ??.?", act(Action::SetOperand, "0:0", "E 0.0"), "U E 0.0 [0:0]"},
      {"U E 0.0", insert("0", kBehind, "CONTACT"), "U E 0.0; U ??.? [1:0]"},
      {"U E 0.0; U E 0.1", insert("1", kBehind, "COIL"), "U E 0.0; U E 0.1; = ??.? [2:0]"},
      {"U E 0.0; U E 0.1; = A 3.0", insert("0", kParallel, "CONTACT", {"A 1.0"}),
       "U(; O E 0.0; O A 1.0; ); U E 0.1; = A 3.0 [2:-1]"},
      {"U(; O E 0.0; O A 1.0; ); U E 0.1; = A 3.0", act(Action::CloseBranch, "2"),
       "U E 0.0; U E 0.1; O A 1.0; = A 3.0 [2:-1]"},
  });
}

// A bare `=` takes the result of the network before: a picture never writes one.
TEST(Edit, PutsNoCoilWithoutLogic) {
  expectAll({
      {"", insert("", kBehind, "COIL"), "U ??.?; = ??.? [1:0]"},
      {"", insert("", kBehind, "S", {"A 3.0"}), "U ??.?; S A 3.0 [1:-1]"},
      {"", insert("", kBehind, "SAVE"), "U ??.?; SAVE [1:-1]"},
      {"", insert("", kBehind, "SD"), "U ??.?; L ???; SE ??? [2:0]"},
      {"U ??.?; = A 3.0", insert("1", kBehind, "CONTACT_NOT", {"E 0.0"}),
       "UN E 0.0; = A 3.0 [0:-1]"},
      {"U ??.?; = A 3.0", insert("1", kBehind, "NOT"), "U ??.?; NOT; = A 3.0 [1:-1]"},
  });
}

void expectNoLogic(const char* bare, const Rules& rules) {
  const Statements written = test::statements(bare);
  for (const Unfinished unfinished : {Unfinished::Refused, Unfinished::Allowed}) {
    const auto network = read(written, rules, unfinished);
    ASSERT_FALSE(network) << bare;
    EXPECT_EQ(network.error().reason, Reason::NoLogic) << bare;
    EXPECT_EQ(network.error().statement, 0u) << bare;
  }
}

// Of a whole network; a copied part may begin with them.
TEST(Reading, LeavesCoilsWithoutLogicAwl) {
  for (const char* bare : {"= A 3.0", "S A 3.0", "R A 3.0", "= A 1.0; S A 1.1"}) {
    expectNoLogic(bare, graph7::rules());
    expectNoLogic(bare, graph5::rules());
  }
  for (const char* bare : {"L S5T#2S; SE T 1", "SAVE", "CC FC 1"})
    expectNoLogic(bare, graph7::rules());
  EXPECT_TRUE(read(test::statements("= A 3.0; S A 3.1"), graph7::rules(), Unfinished::Part));
}

TEST(Edit, PutsElementsBeforeAndBehind) {
  expectAll({
      {"U E 0.0; = A 0.0", insert("0", kBefore, "CONTACT"), "U ??.?; U E 0.0; = A 0.0 [0:0]"},
      {"U E 0.0; = A 0.0", insert("1", kBefore, "NOT"), "U E 0.0; NOT; = A 0.0 [1:-1]"},
      {"U E 0.0; = A 0.0", insert("0", kBehind, "P", {"M 1.0"}),
       "U E 0.0; FP M 1.0; = A 0.0 [1:-1]"},
      {"U E 0.0; U E 0.1; = A 0.0", insert("1", kBefore, "CONNECTOR"),
       "U E 0.0; = ??.#; U ??.#; U E 0.1; = A 0.0 [2:0]"},
      {"U E 0.0; = A 0.0", insert("0", kBehind, "POS", {"E 0.1", "M 1.1"}),
       "U E 0.0; U(; U E 0.1; BLD 100; FP M 1.1; ); = A 0.0 [4:-1]"},
      {"O E 0.0; O E 0.1; = A 0.0", insert("2", kBefore, "CONTACT"),
       "U(; O E 0.0; O E 0.1; ); U ??.?; = A 0.0 [4:0]"},
      {"O E 0.0; O E 0.1; = A 0.0", insert("1", kBehind, "CONTACT"),
       "O E 0.0; O; U E 0.1; U ??.?; = A 0.0 [3:0]"},
      {"U E 0.0; = A 0.0", insert("0", kBefore, "NOT"),
       "refused: there must be logic before this element"},
      {"U E 0.0; = A 0.0", insert("7", kBehind, "CONTACT"),
       "refused: the element was not found in the network"},
      {"U E 0.0; = A 0.0", insert("0", kBehind, "NONSENSE"), "refused: the element is unknown"},
  });
}

TEST(Edit, PutsBoxesIntoTheSignal) {
  expectAll({
      {"U E 0.0; = A 0.0", insert("0", kBehind, "SR", {"M 1.0"}),
       "U E 0.0; S M 1.0; U ??.?; R M 1.0; U M 1.0; = A 0.0 [4:-1]"},
      {"U E 0.0", insert("0", kBehind, "S_ODT", {"T 1", "", "S5T#2S"}),
       "U E 0.0; L S5T#2S; SE T 1; NOP; NOP; NOP; NOP [6:-1]"},
      {"U E 0.0; L S5T#2S; SE T 1; NOP; NOP; NOP; NOP", insert("6:3", kAtPin, "CONTACT", {"E 0.1"}),
       "U E 0.0; L S5T#2S; SE T 1; U E 0.1; R T 1; NOP; NOP; NOP [3:-1]"},
      {"U E 0.0; L S5T#2S; SE T 1; NOP; NOP; NOP; NOP", insert("6", kBehind, "COIL", {"A 1.0"}),
       "U E 0.0; L S5T#2S; SE T 1; NOP; NOP; NOP; U T 1; = A 1.0 [7:-1]"},
      {"", insert("", kBehind, "MOVE"), "L ???; T ???; NOP [2:1]"},
      {"L MW 1; T MW 2; NOP", insert("2:-2", kAtPin, "CONTACT", {"E 0.0"}),
       "U E 0.0; SPBNB ->4; L MW 1; T MW 2; NOP [0:-1]"},
      {"L MW 1; T MW 2; NOP", insert("2:1", kAtPin, "CONTACT"), "refused: this pin takes no logic"},
      {"U E 0.0; = A 0.0", insert("0", kParallel, "EQ_I", {"", "MW 1", "5"}),
       "O E 0.0; O(; L MW 1; L 5; ==I; ); = A 0.0 [5:-1]"},
      {"L MW 1; T MW 2; NOP", act(Action::SetOperand, "2:2", "MW 8"), "L MW 1; T MW 8; NOP [2:2]"},
  });
}

TEST(Edit, GivesLogicToTheParametersOfACall) {
  Edit call = insert("", kBehind, "CALL_BOX", {"FC 1"});
  call.arguments = {
      {"ON", "", false, -1, true}, {"N", "MW 1", false, -1, false}, {"OFF", "", false, -1, true}};
  const auto first = apply({}, call, graph7::rules(), kFirstWire);
  ASSERT_TRUE(first);
  EXPECT_EQ(test::text(first->statements), "CALL FC 1; NOP");
  const auto second = apply(first->network, insert("1:3", kAtPin, "CONTACT", {"E 0.1"}),
                            graph7::rules(), kFirstWire);
  ASSERT_TRUE(second);
  EXPECT_EQ(test::text(second->statements), "U E 0.1; = L 20.0; BLD 103; CALL FC 1; NOP");
  const auto direct =
      apply(second->network, act(Action::SetOperand, "4:1", "E 0.0"), graph7::rules(), kFirstWire);
  ASSERT_TRUE(direct);
  EXPECT_EQ(direct->statements[3].arguments[0].text, "E 0.0");
  EXPECT_EQ(direct->statements.size(), second->statements.size());
  const auto third = apply(second->network, insert("4:1", kAtPin, "CONTACT", {"E 0.0"}),
                           graph7::rules(), kFirstWire);
  ASSERT_TRUE(third);
  EXPECT_EQ(test::text(third->statements),
            "U E 0.0; = L 20.0; BLD 103; U E 0.1; = L 20.1; BLD 103; CALL FC 1; NOP");
  EXPECT_EQ(third->statements[6].arguments[0].wire, 160);
  EXPECT_EQ(third->statements[6].arguments[2].text, "L 20.1");
  EXPECT_EQ(edited("U E 0.0; = A 0.0", insert("1", kBehind, "CALL_BOX")),
            "U E 0.0; SPBNB ->3; CALL ???; U BIE; = A 0.0 [3:0]");
}

TEST(Edit, LetsRungsBranch) {
  expectAll({
      {"U E 0.0; = A 0.0", insert("1", kBehind, "S", {"A 0.1"}),
       "U E 0.0; = A 0.0; S A 0.1 [2:-1]"},
      {"U E 0.0; U E 0.1; = A 0.0", insert("0", kBehind, "COIL", {"A 0.1"}),
       "U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; BLD 102; = A 0.1 [7:-1]"},
      {"U E 0.0; = A 0.0", insert("1", kBranch, "CONTACT"),
       "U E 0.0; = L 20.0; U L 20.0; BLD 102; = A 0.0; U L 20.0; U ??.?; = ??.? [6:0]"},
      {"U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; BLD 102; = A 0.1",
       insert("3", kBranch, "R", {"A 0.2"}),
       "U E 0.0; = L 20.0; U L 20.0; U E 0.1; = L 20.1; U L 20.1; BLD 102; = A 0.0; U L 20.1; "
       "BLD 102; R A 0.2; U L 20.0; BLD 102; = A 0.1 [10:-1]"},
      {"O E 0.0; O E 0.1; = A 0.0", insert("0", kBranch, "COIL"),
       "refused: a branch cannot begin here"},
      {"U E 0.0; = L 20.0; U L 20.0; BLD 102; = A 0.0; U L 20.0; BLD 102; = A 0.1",
       act(Action::DeleteRung, "7"), "U E 0.0; = A 0.0 [-1:-1]"},
      {"U E 0.0; = L 20.0; U L 20.0; BLD 102; = A 0.0; U L 20.0; BLD 102; = A 0.1",
       act(Action::DeleteRung, "0"), " [-1:-1]"},
  });
}

// S7-EDIT-13: FUP
TEST(Edit, BuildsGates) {
  expectAll({
      {"", insert("", kBehind, "AND"), "U ??.?; U ??.? [0:0]"},
      {"U E 0.0; U E 0.1; = A 0.0", act(Action::AddInput, "0-1"),
       "U E 0.0; U E 0.1; U ??.?; = A 0.0 [2:0]"},
      {"U E 0.0; U E 0.1; NOT; = A 0.0", act(Action::AddInput, "0-1"),
       "U E 0.0; U E 0.1; U ??.?; NOT; = A 0.0 [2:0]"},
      {"O E 0.0; O E 0.1; = A 0.0", act(Action::AddInput, "0"),
       "O E 0.0; O ??.?; O E 0.1; = A 0.0 [1:0]"},
      {"U E 0.0; U E 0.1; = A 0.0", insert("0-1", kBehind, "OR"),
       "U E 0.0; U E 0.1; O ??.?; = A 0.0 [2:0]"},
      {"U E 0.0; NOT; U E 0.1; = A 0.0", insert("0-1", kBehind, "XOR"),
       "U(; X(; U E 0.0; NOT; ); X ??.?; ); U E 0.1; = A 0.0 [5:0]"},
      {"U E 0.0; = A 0.0", act(Action::AddInput, "0"), "refused: the element is no gate"},
  });
}

TEST(Edit, TurnsRound) {
  expectAll({
      {"U E 0.0; = A 0.0", act(Action::Negate, "0"), "UN E 0.0; = A 0.0 [0:-1]"},
      {"U E 0.0; U E 0.1; = A 0.0", act(Action::Negate, "0-1"),
       "U E 0.0; U E 0.1; NOT; = A 0.0 [1:-1]"},
      {"U E 0.0; U E 0.1; NOT; = A 0.0", act(Action::Negate, "2"),
       "U E 0.0; U E 0.1; = A 0.0 [1:-1]"},
      {"U E 0.0; U(; O E 0.1; O E 0.2; ); = A 0.0", act(Action::Negate, "4"),
       "U E 0.0; U(; U(; O E 0.1; O E 0.2; ); NOT; ); = A 0.0 [5:-1]"},
      {"U E 0.0; U(; U(; O E 0.1; O E 0.2; ); NOT; ); = A 0.0", act(Action::Negate, "7"),
       "U E 0.0; U(; O E 0.1; O E 0.2; ); = A 0.0 [4:-1]"},
      {"U E 0.0; U E 0.1; = A 0.0", act(Action::Negate, "2"),
       "U E 0.0; U E 0.1; NOT; = A 0.0 [3:-1]"},
  });
}

TEST(Edit, TakesOut) {
  expectAll({
      {"U E 0.0; U E 0.1; = A 0.0", act(Action::Delete, "0"), "U E 0.1; = A 0.0 [0:-1]"},
      {"U(; O E 0.0; O M 1.0; ); U E 0.1; = A 0.0", act(Action::Delete, "2"),
       "U E 0.0; U E 0.1; = A 0.0 [0:-1]"},
      {"U(; O E 0.0; O M 1.0; ); U E 0.1; = A 0.0", act(Action::Delete, "3"),
       "U E 0.1; = A 0.0 [0:-1]"},
      {"U E 0.0; NOT; = A 0.0", act(Action::Delete, "0"), "U ??.?; NOT; = A 0.0 [1:-1]"},
      {"U E 0.0; = A 0.0", act(Action::Delete, "1"), "U E 0.0 [0:-1]"},
      {"U E 0.0; = A 0.0", act(Action::Delete, "0"), "U ??.?; = A 0.0 [1:-1]"},
      {"U E 0.0; = A 0.0; U E 0.1; = A 0.1", act(Action::Delete, "1"),
       "U E 0.0; = ??.?; U E 0.1; = A 0.1 [0:-1]"},
      {"U ??.?; = ??.?; U E 0.1; = A 0.1", act(Action::Delete, "1"), "U E 0.1; = A 0.1 [-1:-1]"},
      {"U E 0.0; L S5T#2S; SE T 1; U E 0.1; R T 1; NOP; NOP; NOP", act(Action::Delete, "7:3"),
       "U E 0.0; L S5T#2S; SE T 1; NOP; NOP; NOP; NOP [6:-1]"},
      {"U E 0.0; = A 0.0", act(Action::NewRung, "0"), "U E 0.0; = A 0.0; U ??.?; = ??.? [2:0]"},
  });
}

// JMP and CALL: conditional behind logic, unconditional at the rail.
TEST(Edit, ChoosesJumpsByWhatStandsBefore) {
  expectAll({
      {"U E 0.0", insert("0", kBehind, "JMP"), "U E 0.0; SPB ??? [1:0]"},
      {"U E 0.0", insert("0", kBehind, "JMP_RAIL"), "U E 0.0; SPB ??? [1:0]"},
      {"U E 0.0", insert("", kBehind, "JMP"), "U E 0.0; SPB ??? [1:0]"},
      {"", insert("", kBehind, "JMP"), "SPA ??? [0:0]"},
      {"U E 0.0; = A 0.0", insert("", kBehind, "JMP"), "U E 0.0; = A 0.0; SPA ??? [2:0]"},
      {"U E 0.0", insert("0", kBehind, "CALL_RAIL"), "U E 0.0; CC ??? [1:0]"},
      {"UC FC 1", insert("0", kBefore, "CONTACT"), "U ??.?; CC FC 1 [0:0]"},
      {"U E 0.0; CC FC 1", act(Action::Delete, "0"), "UC FC 1 [0:-1]"},
  });
}

TEST(Edit, LetsCoilsAtTheRailStandAlone) {
  const std::string refused =
      "refused: this coil stands alone at the rail: the rung above it needs a coil first";
  expectAll({
      {"U E 0.0; = A 0.0", insert("0", kBehind, "OPN"), "U E 0.0; = A 0.0; AUF ??? [2:0]"},
      {"U E 0.0", insert("0", kBehind, "OPN"), refused},
      {"U E 0.0", insert("", kBehind, "MCRA"), refused},
      {"U E 0.0", insert("0", kBehind, "MCR_OFF"), refused},
  });
}

// A coil ends its rung: what is put behind it stands before it, in series with all of the rung.
TEST(Edit, PutsBeforeACoilWhatIsPutBehindIt) {
  expectAll({
      {"O E 0.0; O E 0.1; = A 0.0", insert("2", kBehind, "CONTACT"),
       "U(; O E 0.0; O E 0.1; ); U ??.?; = A 0.0 [4:0]"},
      {"O E 0.0; O E 0.1; = A 0.0", insert("2", kBehind, "S_ODT", {"T 1", "", "S5T#2S"}),
       "U(; O E 0.0; O E 0.1; ); L S5T#2S; SE T 1; NOP; NOP; NOP; U T 1; = A 0.0 [9:-1]"},
      {"U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; BLD 102; = A 0.1",
       insert("4", kBehind, "CONTACT", {"E 0.2"}),
       "U E 0.0; = L 20.0; U L 20.0; U E 0.1; U E 0.2; = A 0.0; U L 20.0; BLD 102; = A 0.1 "
       "[4:-1]"},
      {"U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; BLD 102; = A 0.1",
       insert("7", kBehind, "CONTACT", {"E 0.2"}),
       "U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; U E 0.2; = A 0.1 [6:-1]"},
      {"O E 0.0; O E 0.1; SPB ???", insert("2", kBehind, "CONTACT"),
       "U(; O E 0.0; O E 0.1; ); U ??.?; SPB ??? [4:0]"},
      {"SPA ???", insert("0", kBehind, "CONTACT"), "U ??.?; SPB ??? [0:0]"},
      {"O E 0.0; O E 0.1; SAVE", insert("2", kBehind, "CONTACT"),
       "U(; O E 0.0; O E 0.1; ); U ??.?; SAVE [4:0]"},
      {"O E 0.0; O E 0.1; = A 0.0", insert("2", kBehind, "AND"),
       "U(; O E 0.0; O E 0.1; ); U ??.?; = A 0.0 [4:0]"},
      {"AUF ???", insert("0", kBehind, "CONTACT"),
       "refused: this coil stands alone at the rail: nothing can stand before it"},
      {"AUF ???", insert("0", kBehind, "AND"),
       "refused: this coil stands alone at the rail: nothing can stand before it"},
  });
}

// Behind the group, not in one of its branches.
TEST(Edit, PutsElementsBehindAGroup) {
  expectAll({
      {"O E 0.0; O E 0.1; = A 0.0", insert("0-1", kBehind, "CONTACT"),
       "U(; O E 0.0; O E 0.1; ); U ??.?; = A 0.0 [4:0]"},
      {"U(; O E 0.0; O E 0.1; ); U E 0.2; = A 0.0", insert("3", kBehind, "CONTACT"),
       "U(; O E 0.0; O E 0.1; ); U ??.?; U E 0.2; = A 0.0 [4:0]"},
  });
}

TEST(Edit, NegatesInputsOfGates) {
  expectAll({
      {"O E 0.0; O E 0.1; = A 0.0", insert("0", kBehind, "NOT"),
       "ON E 0.0; O E 0.1; = A 0.0 [0:-1]"},
      {"O E 0.0; O E 0.1; = A 0.0", insert("0:0", kBehind, "NOT"),
       "ON E 0.0; O E 0.1; = A 0.0 [0:-1]"},
      {"U E 0.0; U E 0.1; = A 0.0", insert("1:0", kBehind, "NOT"),
       "U E 0.0; UN E 0.1; = A 0.0 [1:-1]"},
      {"U E 0.0; U E 0.1; = A 0.0", insert("1", kBehind, "NOT"),
       "U E 0.0; U E 0.1; NOT; = A 0.0 [2:-1]"},
  });
}

// A gate takes up the rung that waits for its coil.
TEST(Edit, GatesGoOnWithARungWithoutCoil) {
  expectAll({
      {"U E 0.0", insert("", kBehind, "OR"), "O E 0.0; O ??.? [1:0]"},
      {"U E 0.0; = A 0.0", insert("", kBehind, "AND"), "U E 0.0; = A 0.0; U ??.?; U ??.? [2:0]"},
  });
}

TEST(Edit, ReplacesMissingOperandsAtPins) {
  const std::string box = "U E 0.0; S M 1.0; U ??.?; R M 1.0; NOP";
  const std::string named = "U E 0.0; S M 1.0; UN E 0.1; R M 1.0; NOP [2:-1]";
  expectAll({
      {box, insert("4:2", kAtPin, "CONTACT_NOT", {"E 0.1"}), named},
      {box, insert("2", kBehind, "CONTACT_NOT", {"E 0.1"}), named},
      {"U ??.?; = A 0.0", insert("0", kBehind, "CONTACT"), "U ??.?; U ??.?; = A 0.0 [1:0]"},
  });
}

TEST(Edit, PutsContactsBeforeARung) {
  expectAll({
      {"O E 0.0; O E 0.1; = A 0.0", insert("0", kBefore, "CONTACT"),
       "U ??.?; U(; O E 0.0; O E 0.1; ); = A 0.0 [0:0]"},
      {"U(; O E 0.0; O E 0.1; ); U E 0.2; = A 0.0", insert("1", kBefore, "CONTACT"),
       "U ??.?; U(; O E 0.0; O E 0.1; ); U E 0.2; = A 0.0 [0:0]"},
      {"U E 0.0; = A 0.0", insert("", kBefore, "CONTACT"), "U ??.?; U E 0.0; = A 0.0 [0:0]"},
      {"L MW 1; T MW 2; NOP", insert("2", kBefore, "CONTACT", {"E 0.0"}),
       "U E 0.0; SPBNB ->4; L MW 1; T MW 2; NOP [0:-1]"},
      {"U E 0.0; S M 1.0; U E 0.1; R M 1.0; NOP", insert("4", kBefore, "CONTACT", {"E 0.2"}),
       "U E 0.0; U E 0.2; S M 1.0; U E 0.1; R M 1.0; NOP [1:-1]"},
  });
}

TEST(Edit, KeepsTheRulesOfStep5) {
  const std::string box = "U E 0.0; S M 1.0; U E 0.1; R M 1.0; NOP";
  expectAll(
      {
          {box, insert("4", kBehind, "SR"), "refused: a network has at most one box"},
          {box, insert("0", kBehind, "NOT"), "refused: the element is unknown"},
          {box, insert("0", kBehind, "XOR"), "refused: the element is unknown"},
          {"U E 0.0; = A 0.0", insert("1", kBranch, "CONTACT"),
           "refused: a branch cannot begin here"},
      },
      graph5::rules());
}

// S5-KOPFUP-05: before OR STEP 5 has boxes only in FUP.
TEST(Edit, LeavesALadderALadder) {
  const std::string rung = "O E 0.0; O E 0.1; = A 0.0";
  const std::string refused =
      "refused: ladder cannot show this: only function blocks could show the network then";
  const Edit box = insert("1", kBehind, "SR", {"M 1.0"});
  Edit inLadder = box;
  inLadder.ladder = true;
  EXPECT_EQ(edited(rung, inLadder, graph5::rules()), refused);
  EXPECT_TRUE(edited(rung, box, graph5::rules()).starts_with("O E 0.0; O(; U E 0.1; S M 1.0"));
  // What was no ladder before is no worse.
  const std::string gates = "X E 0.0; X E 0.1; = A 0.0";
  Edit more = act(Action::Negate, "0");
  more.ladder = true;
  EXPECT_EQ(edited(gates, more).find("refused"), std::string::npos);
}

// A rung for each element of the family: it can be put in, and stands there with all its pins.
void expectEveryElement(const Rules& rules) {
  const Network unfinished = networkOf("U E 0.0", rules);
  const Network finished = networkOf("U E 0.0; = A 0.0", rules);
  for (const Element& element : rules.elements->elements()) {
    const bool rail = element.row.kind == ElementClass::RailCoil;
    const Network& network = rail ? finished : unfinished;
    Edit edit = insert("0", kBehind, std::string(element.row.id));
    if (element.row.kind == ElementClass::Call) edit.operands = {operand("FC 1")};
    const auto after = apply(network, edit, rules, kFirstWire);
    ASSERT_TRUE(after) << element.row.id << ": " << text(after.error(), Language::English);
    Network whole = after->network;
    const auto at = locate(whole, {after->select.node});
    ASSERT_TRUE(at) << element.row.id;
    const Element* found = at->coil != nullptr ? at->coil->element : at->node().element;
    EXPECT_EQ(found->row.id, rules.elements->counterpart(element, true).row.id);
  }
}

TEST(Edit, PutsEveryElementOfStep7IntoARung) { expectEveryElement(graph7::rules()); }
TEST(Edit, PutsEveryElementOfStep5IntoARung) { expectEveryElement(graph5::rules()); }

}  // namespace
}  // namespace merker::graph
