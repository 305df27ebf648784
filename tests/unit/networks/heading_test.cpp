// Networks come and go, and their titles change, as lines of the text.
#include <gtest/gtest.h>

#include "networks/source_edit.h"

namespace merker::networks {
namespace {

const char* const kBlock =
    "FUNCTION FC 1 : VOID\n"
    "BEGIN\n"
    "NETWORK\n"
    "TITLE = one\n"
    "// first\n"
    "// second\n"
    "      U     E 0.0;\n"
    "      =     A 0.0;\n"
    "\n"
    "NETWORK\n"
    "TITLE = two\n"
    "      U     E 0.1;\n"
    "      =     A 0.1;\n"
    "END_FUNCTION\n";

source::SourceFile fileOf(const std::string& text) { return {"a.awl", text}; }

std::string done(const source::SourceFile& file, const Edited& edit) {
  return edit ? applied(file, *edit) : std::string(text(edit.error(), graph::Language::English));
}

std::string titles(const std::string& text, const Surroundings& around = {}) {
  const auto block = blockAt(fileOf(text), 1, around);
  if (!block) return "no block";
  std::string out;
  for (const Network& network : block->networks) {
    out += network.source.title + "(";
    for (const std::string& line : network.source.comment) out += line + "|";
    out += std::to_string(network.source.statements.size()) + ") ";
  }
  return out;
}

// S7-EDIT-08
TEST(Headings, ofANetworkAreRead) { EXPECT_EQ(titles(kBlock), "one( first| second|2) two(2) "); }

TEST(Headings, areChanged) {
  const auto file = fileOf(kBlock);
  const auto edit = changeHeading(file, 8, 1, {"new", {" only"}}, {});
  ASSERT_TRUE(edit);
  EXPECT_EQ(titles(done(file, edit)), "new( only|2) two(2) ");
  EXPECT_EQ(edit->from, 3u);
  EXPECT_EQ(edit->to, 7u);
}

TEST(Headings, mustBeOneLineEach) {
  const auto file = fileOf(kBlock);
  EXPECT_EQ(changeHeading(file, 8, 1, {"a\nNETWORK", {}}, {}).error().obstacle, Obstacle::Text);
  EXPECT_EQ(changeHeading(file, 8, 1, {"a", {"= A 0.0 = 1"}}, {}).error().obstacle, Obstacle::Text);
  EXPECT_EQ(changeHeading(file, 8, 3, {"a", {}}, {}).error().obstacle, Obstacle::NoNetwork);
}

TEST(Networks, comeBeforeAndBehind) {
  const auto file = fileOf(kBlock);
  const auto before = insertNetwork(file, 1, 1, true, {"zero", {}}, {});
  EXPECT_EQ(titles(done(file, before)), "zero(0) one( first| second|2) two(2) ");
  const auto behind = insertNetwork(file, 1, 2, false, {"three", {" x"}}, {});
  EXPECT_EQ(titles(done(file, behind)), "one( first| second|2) two(2) three( x|0) ");
  EXPECT_EQ(behind->network, 3u);
}

TEST(Networks, goAway) {
  const auto file = fileOf(kBlock);
  EXPECT_EQ(titles(done(file, removeNetwork(file, 1, 1, {}))), "two(2) ");
  EXPECT_EQ(titles(done(file, removeNetwork(file, 1, 2, {}))), "one( first| second|2) ");
}

TEST(Networks, ofABlockWithoutHeadsGetThem) {
  const auto file = fileOf("FUNCTION FC 1 : VOID\nBEGIN\n U E 0.0;\n = A 0.0;\nEND_FUNCTION\n");
  EXPECT_EQ(titles(done(file, changeHeading(file, 1, 1, {"now", {}}, {}))), "now(2) ");
  EXPECT_EQ(titles(done(file, insertNetwork(file, 1, 1, true, {"new", {}}, {}))), "new(0) (2) ");
}

TEST(Networks, ofAnEmptyBlockAreOne) {
  const auto file = fileOf("FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n");
  EXPECT_EQ(titles(std::string(file.text())), "(0) ");
  const auto first = insertNetwork(file, 1, 1, false, {"new", {}}, {});
  EXPECT_EQ(titles(done(file, first)), "new(0) ");
  EXPECT_EQ(first->network, 1u);
}

std::string labelled(const std::string& text, const std::string& label) {
  const auto file = fileOf("FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n" + text + "END_FUNCTION\n");
  const auto edit = changeLabel(file, 1, 1, label, {});
  if (!edit) return done(file, edit);
  const std::string after = done(file, edit);
  const auto block = blockAt(fileOf(after), 1, {});
  EXPECT_EQ(block->networks[0].source.places[0].label, label) << after;
  return edit->lines.empty() ? "" : edit->lines.front();
}

// S7-EDIT-08
TEST(Labels, standBeforeTheFirstStatement) {
  EXPECT_EQ(labelled("      U     E 0.0; // go\n", "M001"), "M001: U     E 0.0; // go");
  EXPECT_EQ(labelled("  U E 0.0;\n", "M001"), "M001: U E 0.0;");
  EXPECT_EQ(labelled("M1:   U E 0.0;\n", "Ende"), "Ende: U E 0.0;");
  EXPECT_EQ(labelled("M1:   U E 0.0;\n", ""), "      U E 0.0;");
  EXPECT_EQ(labelled("M1:\n      U E 0.0;\n", "M2"), "M2:   U E 0.0;");
  EXPECT_EQ(labelled("M1:   U E 0.0;\n", "M1"), "");
}

TEST(Labels, areRefusedThatAreNoneOrTaken) {
  for (const char* label : {"toolong", "1a", "a b", "M2", "a:", "a\n"})
    EXPECT_NE(labelled(" U E 0.0;\nM2: = A 0.0;\n", label).find("a label must be"),
              std::string::npos)
        << label;
}

// It stands alone on its line until the first statement comes.
TEST(Labels, waitInAnEmptyNetwork) {
  const std::string head = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nTITLE = one\n",
                    rest = "NETWORK\n      U     E 1.0;\n      SPB   M001;\nEND_FUNCTION\n";
  const auto labelOf = [](const std::string& text, std::size_t network) {
    return blockAt(fileOf(text), 1, {})->networks[network - 1].source.label;
  };
  const std::string waits =
      done(fileOf(head + rest), changeLabel(fileOf(head + rest), 1, 1, "M001", {}));
  EXPECT_EQ(waits, head + "M001:\n" + rest);
  EXPECT_EQ(labelOf(waits, 1), "M001");
  EXPECT_EQ(labelOf(waits, 2), "") << "it is that of the network above";
  const auto file = fileOf(waits);
  EXPECT_EQ(changeLabel(file, 1, 2, "M001", {}).error().obstacle, Obstacle::Label) << "it is taken";
  EXPECT_EQ(done(file, changeLabel(file, 1, 1, "M002", {})), head + "M002:\n" + rest);
  EXPECT_EQ(done(file, changeLabel(file, 1, 1, "", {})), head + rest);
  EXPECT_EQ(done(file, changeLabel(file, 1, 1, "M001", {})), waits);
  graph::Edit contact;
  contact.element = "CONTACT";
  const std::string drawn = done(file, edit(file, 1, 1, contact, {}));
  EXPECT_EQ(drawn, head + "M001: U     ??.?;\n" + rest);
  graph::Edit away;
  away.action = graph::Action::Delete;
  away.at.node = 0;
  EXPECT_EQ(done(fileOf(drawn), edit(fileOf(drawn), 1, 1, away, {})), waits);
}

// S5-KOPFUP-01
TEST(Networks, ofStep5ComeBeforeTheEndOfTheBlock) {
  Surroundings around;
  around.language = source::Language::Step5;
  const source::SourceFile file(
      "a.s5", "PB 1\nNETZWERK 1  one\n! why\n : U    E 0.0\n : =    A 0.0\n : BE\n");
  EXPECT_EQ(titles(std::string(file.text()), around), "one( why|2) ");
  const std::string more = done(file, insertNetwork(file, 1, 1, false, {"two", {" new"}}, around));
  EXPECT_EQ(titles(more, around), "one( why|2) two( new|0) ");
  EXPECT_TRUE(more.ends_with(" : BE\n"));
  EXPECT_EQ(titles(done(file, removeNetwork(file, 1, 1, around)), around), "(0) ");
}

}  // namespace
}  // namespace merker::networks
