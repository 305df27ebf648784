// Drawings of large networks: nothing is left out, and they grow with what they show.
#include "graph/picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/read.h"
#include "graph7/rules.h"
#include "random_networks.h"
#include "statement_text.h"

namespace merker::graph {
namespace {

constexpr std::uint32_t kMany = 3900;

// A rung of so many contacts, joined by `op`, before them contacts beside each other. `term`: all
// of this has one more beside it.
Network contacts(Op op, std::uint32_t count, std::uint32_t beside = 0, bool term = false) {
  Statements statements;
  const auto add = [&statements](Op what, Operand operand) {
    Statement& statement = statements.emplace_back();
    statement.op = what;
    statement.operand = std::move(operand);
  };
  if (beside > 0) add(Op::AND_OPEN, {});
  for (std::uint32_t i = 0; i < beside; ++i) add(Op::OR, test::bit(i));
  if (beside > 0) add(Op::CLOSE, {});
  for (std::uint32_t i = 0; i < count; ++i) add(op, test::bit(i));
  if (term) add(Op::AND_BEFORE_OR, {});
  if (term) add(Op::AND, test::bit(0));
  add(Op::ASSIGN, test::bit(count));
  return read(statements, graph7::rules()).value();
}

std::size_t contactsIn(const std::vector<std::string>& lines) {
  std::size_t found = 0;
  for (const std::string& line : lines)
    for (auto at = line.find("┤ ├"); at != std::string::npos; at = line.find("┤ ├", at + 1))
      ++found;
  return found;
}

TEST(Pictures, ShowEveryContactOfALargeNetwork) {
  for (const Op op : {Op::AND, Op::OR}) {
    const auto lines = toText(kop(contacts(op, kMany), {}));
    ASSERT_TRUE(lines);
    EXPECT_EQ(contactsIn(*lines), kMany);
  }
}

// S7-EDIT-15
TEST(Pictures, GoOnBelowWhereARungIsWiderThanThePage) {
  constexpr const char* kSixContacts =
      "U M 0.1; U M 0.2; U M 0.3; U M 0.4; U M 0.5; U M 0.6; = A 1.0; = A 1.1";
  const Network network = read(test::statements(kSixContacts), graph7::rules()).value();
  const std::vector<std::string> expected = {"│ M 0.1  M 0.2",
                                             "├──┤ ├────┤ ├────>1",
                                             "│     M 0.3  M 0.4",
                                             "│1>────┤ ├────┤ ├────>2",
                                             "│     M 0.5  M 0.6   A 1.0",
                                             "│2>────┤ ├────┤ ├──┬──( )──",
                                             "│                  │ A 1.1",
                                             "│                  └──( )──"};
  EXPECT_EQ(toText(kop(network, {Language::German, 36})).value(), expected);
}

using Lines = std::vector<std::string>;
Lines drawn(Picture (*draw)(const Network&, const Style&), const char* statements) {
  const auto network = read(test::statements(statements), graph7::rules());
  return toText(draw(network.value(), {})).value();
}

TEST(Pictures, JoinBranchesAtTheRailByTheRail) {
  EXPECT_EQ(drawn(kop, "U M 0.0; U M 0.1; O; U(; O M 0.2; O M 0.3; ); U M 0.4; O M 0.5; = A 1.0"),
            (Lines{"│ M 0.0  M 0.1     A 1.0",   //
                   "├──┤ ├────┤ ├───┬───( )──",  //
                   "│ M 0.2   M 0.4 │",          //
                   "├──┤ ├──┬──┤ ├──┤",          //
                   "│ M 0.3 │       │",          //
                   "├──┤ ├──┘       │",          //
                   "│ M 0.5         │",          //
                   "├──┤ ├──────────┘"}));
}

// What is wider than the contacts above it does not touch the rail.
TEST(Pictures, LeaveAColumnBetweenTheRailAndOperands) {
  for (const std::string& line : drawn(kop, "L EB 2; L MW 100; ==I; = A 1.0"))
    EXPECT_TRUE(line.starts_with("│ ") || line.starts_with("├─")) << line;
}

TEST(Pictures, EndAllCoilsAtOneColumn) {
  EXPECT_EQ(drawn(kop, "U M 0.0; = A 1.0; L S5T#2H46M30S; SE T 1"),
            (Lines{"│ M 0.0          A 1.0",   //
                   "├──┤ ├──┬─────────( )──",  //
                   "│       │     T 1",        //
                   "│       └─────(SE)─────",  //
                   "│         S5T#2H46M30S"}));
}

TEST(Pictures, BranchAColumnBehindABox) {
  EXPECT_EQ(drawn(fup, "U M 0.0; U M 0.1; = A 1.0; S A 1.1"), (Lines{"      ┌───┐",             //
                                                                     "      │ & │      A 1.0",  //
                                                                     "M 0.0─┤   │      ┌───┐",  //
                                                                     "M 0.1─┤   ├─┬────┤ = │",  //
                                                                     "      └───┘ │    └───┘",  //
                                                                     "            │    A 1.1",  //
                                                                     "            │    ┌───┐",  //
                                                                     "            └────┤ S │",  //
                                                                     "                 └───┘"}));
}

TEST(Pictures, NameEachCoilInTheMiddle) {
  EXPECT_EQ(drawn(fup, "U M 0.0; L S5T#2S; SE T 1"), (Lines{"        T 1",    //
                                                            "       ┌────┐",  //
                                                            " M 0.0─┤ SE │",  //
                                                            "S5T#2S─┤    │",  //
                                                            "       └────┘"}));
}

TEST(Pictures, AreNotWiderThanThePage) {
  const auto lines = toText(kop(contacts(Op::AND, kMany), {Language::German, 100}));
  ASSERT_TRUE(lines);
  EXPECT_EQ(contactsIn(*lines), kMany);
  for (const std::string& line : *lines) EXPECT_LE(columns(line), 100) << line;
}

TEST(Pictures, GrowWithWhatTheyShow) {
  for (const Op op : {Op::AND, Op::OR})
    for (const auto draw : {kop, fup}) {
      const auto small = draw(contacts(op, kMany / 10), {}).shapes.size();
      EXPECT_LE(draw(contacts(op, kMany), {}).shapes.size(), 10 * small);
    }
}

// Behind a branch goes what its temporary bit holds, never power.
TEST(Pictures, HavePowerAtTheRailAlone) {
  for (const char* text :
       {"U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 4.0; UN L 20.0; U E 0.2; = A 4.1; U L 20.0; "
        "BLD 102; = A 4.2",
        "U E 0.0; = A 4.0; = L 20.0; U L 20.0; BLD 102; = A 4.2; U L 20.0; U E 0.1; = A 4.3"}) {
    const Picture picture = kop(read(test::statements(text), graph7::rules()).value(), {});
    for (const Shape& shape : picture.shapes)
      EXPECT_TRUE(shape.kind != ShapeKind::Wire || !shape.flow.empty() || shape.x == 1) << text;
  }
}

// The signal within a branch is that of all elements so far.
TEST(Pictures, KnowNoSignalBehindTooManyElementsOfABranch) {
  for (const std::uint32_t count : {std::uint32_t{kMostFlows}, kMany}) {
    std::size_t unknown = 0;
    for (const Shape& shape : kop(contacts(Op::AND, count, 0, true), {}).shapes) {
      EXPECT_LE(shape.flow.size(), kMostFlows + 1);
      if (!isKnown(shape.flow)) ++unknown;
    }
    EXPECT_EQ(unknown > 0, count > kMostFlows);
  }
}

TEST(Pictures, AreRefusedAsTextWhereTheyAreTooLarge) {
  const auto lines = toText(kop(contacts(Op::AND, kMany / 2, kMany / 2), {}));
  ASSERT_FALSE(lines);
  EXPECT_EQ(lines.error(), Reason::Size);
}

int widthOfNestedBranches(int count) {
  std::string text = "U E 0.0; = L 20.0; U L 20.0; BLD 102; = A 0.0";
  for (int i = 0; i < count; ++i) {
    const auto wire = [](int n) { return fmt::format("L {}.{}", 20 + n / 8, n % 8); };
    text += fmt::format("; U {0}; U E 0.1; = {1}; U {1}; BLD 102; = A 0.0", wire(i), wire(i + 1));
  }
  const auto network = read(test::statements(text), graph7::rules(), Unfinished::Allowed);
  EXPECT_TRUE(network);
  return network ? fup(*network, {}).w : 0;
}

// The deeper ones begin anew at the rail: drawing takes no longer than the network is.
TEST(Picture, BranchesAreNestedSoDeep) {
  EXPECT_LT(widthOfNestedBranches(5), widthOfNestedBranches(20));
  EXPECT_EQ(widthOfNestedBranches(200), widthOfNestedBranches(400));
}

// A bit that is read in the middle of a rung is an operand; where rungs only begin with it, a wire.
TEST(Pictures, NameALocalBitOnlyWhereItIsAContact) {
  const auto named = [](const std::string& second) {
    const auto network = read(
        test::statements("U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; " + second + "; = A 0.1"),
        graph7::rules());
    return std::ranges::count(kop(network.value(), {}).shapes, "L 20.0", &Shape::text);
  };
  EXPECT_EQ(named("U L 20.0; U E 0.3"), 0);
  EXPECT_EQ(named("U E 0.3; U L 20.0"), 2) << "connector and contact";
}

}  // namespace
}  // namespace merker::graph
