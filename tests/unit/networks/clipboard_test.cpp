// Elements and networks are copied as AWL, come back from it, and go to another place.
#include <gtest/gtest.h>

#include "networks/source_edit.h"

namespace merker::networks {
namespace {

using graph::Selection;

constexpr const char* kJumping =
    "FUNCTION FC 1 : VOID\n"
    "VAR_TEMP\n"
    "  ready : BOOL;\n"
    "END_VAR\n"
    "BEGIN\n"
    "NETWORK\n"
    "TITLE = one\n"
    "// why\n"
    "M001: U     E 0.0; // first\n"
    "      U     #ready;\n"
    "      =     A 0.0;\n"
    "\n"
    "NETWORK\n"
    "TITLE = two\n"
    "      O     E 1.0;\n"
    "      O     E 1.1;\n"
    "      SPB   M001;\n"
    "END_FUNCTION\n";

constexpr const char* kTwoOfStep5 =
    "PB 1\n"
    "NETZWERK 1  one\n"
    "      U     E 0.0\n"
    "      =     A 0.0\n"
    "NETZWERK 2  two\n"
    "      U     E 0.1\n"
    "      =     A 0.1\n"
    "      BE\n";

source::SourceFile sourceOf(const std::string& text) { return {"a.awl", text}; }
const Surroundings kStep5{source::Language::Step5, nullptr, nullptr, nullptr, {}};

std::string asText(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}
std::string copied(std::size_t network, const std::vector<Selection>& elements,
                   const char* text = kJumping, const Surroundings& around = {}) {
  const auto lines = copy(sourceOf(text), 1, network, elements, around);
  return lines ? asText(*lines)
               : std::string(networks::text(lines.error(), graph::Language::English));
}

graph::Edit at(int node, graph::Place place) {
  graph::Edit edit;
  edit.at.node = node;
  edit.place = place;
  return edit;
}
std::string outcome(const std::string& text, const Edited& edit) {
  return edit ? applied(sourceOf(text), *edit)
              : std::string(networks::text(edit.error(), graph::Language::English));
}
std::string pasted(std::size_t network, const graph::Edit& place, const std::string& lines,
                   const std::string& text = kJumping, const Surroundings& around = {}) {
  return outcome(text, paste(sourceOf(text), 1, network, place, lines, around));
}
std::string moved(std::size_t network, const graph::Edit& place, const Origin& from,
                  const std::string& text = kJumping, const Surroundings& around = {}) {
  return outcome(text, move(sourceOf(text), 1, network, place, from, around));
}

std::string exchanged(std::string text, const std::string& what, const std::string& by) {
  const std::size_t begin = text.find(what);
  EXPECT_NE(begin, std::string::npos) << what;
  return begin == std::string::npos ? text : text.replace(begin, what.size(), by);
}

// S7-EDIT-08
TEST(Clipboard, HoldsElementsAsAwl) {
  EXPECT_EQ(copied(1, {{1}}), "      U     #ready;\n");
  EXPECT_EQ(copied(2, {{1, -1, 0}}), "      O     E 1.0;\n      O     E 1.1;\n");
  EXPECT_EQ(copied(2, {{2}}), "      SPA   M001;\n");
  EXPECT_EQ(copied(1, {{7}}), "the element was not found in the network");
  EXPECT_EQ(copied(3, {{0}}), "the network was not found");
  EXPECT_EQ(copied(1, {{0}}, kTwoOfStep5, kStep5), "      U     E 0.0\n");
}

TEST(Clipboard, HoldsBoxesWithTheirLabels) {
  const char* box =
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n      U     E 0.0;\n      SPBNB _007;\n"
      "      L     MW 1;\n      T     MW 2;\n_007: NOP   0;\nEND_FUNCTION\n";
  const std::string copy = copied(1, {{4}}, box);
  EXPECT_EQ(copy, "      L     MW 1;\n      T     MW 2;\n      NOP   0;\n");
  EXPECT_EQ(
      pasted(1, at(1, graph::Place::Behind), copy),
      exchanged(kJumping, "      U     #ready;\n      =     A 0.0;\n",
                "      U     #ready;\n      SPBNB _001;\n      L     MW 1;\n      T     MW 2;\n"
                "      SET;\n      SAVE;\n      CLR;\n_001: U     BIE;\n"
                "      =     A 0.0;\n"));
}

TEST(Clipboard, HoldsNetworksWithTitleAndComment) {
  EXPECT_EQ(copied(1, {}),
            "NETWORK\nTITLE = one\n// why\nM001: U     E 0.0; // first\n      U     #ready;\n"
            "      =     A 0.0;\n");
}

TEST(Pastes, PutElementsIntoANetwork) {
  EXPECT_EQ(pasted(2, at(2, graph::Place::Behind), "U #ready"),
            exchanged(kJumping, "      O     E 1.0;\n      O     E 1.1;\n",
                      "      U(;\n      O     E 1.0;\n      O     E 1.1;\n      );\n"
                      "      U     #ready;\n"));
  EXPECT_EQ(pasted(1, at(1, graph::Place::Parallel), "UN E 5.0;\n// a comment\n"),
            exchanged(kJumping, "      U     #ready;\n",
                      "      U(;\n      O     #ready;\n      ON    E 5.0;\n      );\n"));
  EXPECT_EQ(pasted(1, at(0, graph::Place::Behind), " : U E 0.1", kTwoOfStep5, kStep5),
            exchanged(kTwoOfStep5, "E 0.0\n", "E 0.0\n      U     E 0.1\n"));
}

// Their labels are free in the block; their own jumps follow.
TEST(Pastes, PutNetworksBehindANetwork) {
  EXPECT_EQ(pasted(1, at(-1, graph::Place::Behind), copied(1, {})),
            exchanged(kJumping, "\nNETWORK\nTITLE = two",
                      "NETWORK\nTITLE = one\n// why\nM002: U     E 0.0; // first\n"
                      "      U     #ready;\n      =     A 0.0;\n\nNETWORK\nTITLE = two"));
  EXPECT_EQ(pasted(2, at(-1, graph::Place::Behind),
                   "NETWORK\nM001: U E 7.0;\n SPB M001;\nNETWORK\n U E 7.1;\n SPB M009;\n"),
            exchanged(kJumping, "END_FUNCTION",
                      "NETWORK\nM002: U E 7.0;\n SPB M002;\nNETWORK\n U E 7.1;\n SPB M009;\n"
                      "END_FUNCTION"));
  EXPECT_EQ(pasted(1, at(-1, graph::Place::Before), "NETWORK\nTITLE = zero\n"),
            exchanged(kJumping, "NETWORK\n", "NETWORK\nTITLE = zero\nNETWORK\n"));
}

TEST(Pastes, LeaveALadderALadder) {
  const std::string text =
      exchanged(kTwoOfStep5, "      U     E 0.0\n", "      O     E 0.0\n      O     E 0.2\n");
  const char* box = "U E 1.0\nS M 1.0\nU E 1.1\nR M 1.0\nU M 1.0\n";
  const std::string refused =
      "ladder cannot show this: only function blocks could show the network then";
  graph::Edit place = at(1, graph::Place::Behind);
  EXPECT_NE(pasted(1, place, box, text, kStep5), refused);
  place.ladder = true;
  EXPECT_EQ(pasted(1, place, box, text, kStep5), refused);
  const std::string two = exchanged(text, "      U     E 0.1\n",
                                    "      U     E 0.1\n      S     M 1.0\n      U     E 0.4\n"
                                    "      R     M 1.0\n      U     M 1.0\n");
  place.ladder = false;
  EXPECT_NE(moved(1, place, {2, {4}}, two, kStep5), refused);
  place.ladder = true;
  EXPECT_EQ(moved(1, place, {2, {4}}, two, kStep5), refused);
}

TEST(Pastes, FillAnEmptyBlock) {
  const std::string empty = "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n";
  EXPECT_EQ(pasted(1, at(-1, graph::Place::Behind), "NETWORK\n U E 0.0;\n", empty),
            exchanged(empty, "BEGIN\n", "BEGIN\nNETWORK\n U E 0.0;\n"));
  EXPECT_EQ(pasted(1, at(-1, graph::Place::Behind), "U E 0.0", empty),
            exchanged(empty, "BEGIN\n", "BEGIN\n      U     E 0.0;\n"));
}

TEST(Pastes, NumberTheNetworksOfStep5) {
  EXPECT_EQ(pasted(1, at(-1, graph::Place::Behind), copied(1, {}, kTwoOfStep5, kStep5), kTwoOfStep5,
                   kStep5),
            "PB 1\n"
            "NETZWERK 1  one\n      U     E 0.0\n      =     A 0.0\n"
            "NETZWERK 2  one\n      U     E 0.0\n      =     A 0.0\n"
            "NETZWERK 3  two\n      U     E 0.1\n      =     A 0.1\n"
            "      BE\n");
}

TEST(Pastes, OfAnythingElseAreRefused) {
  const std::string refused =
      "what is pasted must be statements that can be drawn, or whole networks";
  for (const char* text : {"", "// nothing\n", "hello", "L MW 1;\nTAK;\n", "END_FUNCTION\n",
                           "U E 0.0;\nEND_FUNCTION\nFUNCTION FC 1 : VOID\nBEGIN\n", "\""})
    EXPECT_EQ(pasted(1, at(0, graph::Place::Behind), text), refused) << text;
  EXPECT_EQ(pasted(3, at(0, graph::Place::Behind), "U E 0.0"), "the network was not found");
  EXPECT_EQ(pasted(1, at(9, graph::Place::Behind), "U E 0.0"),
            "the element was not found in the network");
}

TEST(Moves, TakeElementsToAnotherPlace) {
  EXPECT_EQ(moved(1, at(1, graph::Place::Behind), {1, {0}}),
            exchanged(kJumping, "M001: U     E 0.0; // first\n      U     #ready;\n",
                      "M001: U     #ready;\n      U     E 0.0;\n"));
  EXPECT_EQ(moved(2, at(2, graph::Place::Behind), {1, {1}}),
            exchanged(exchanged(kJumping, "      U     #ready;\n", ""),
                      "      O     E 1.0;\n      O     E 1.1;\n",
                      "      U(;\n      O     E 1.0;\n      O     E 1.1;\n      );\n"
                      "      U     #ready;\n"));
  EXPECT_EQ(moved(1, at(0, graph::Place::Parallel), {2, {2}}), "a coil cannot stand here");
  EXPECT_EQ(moved(2, at(9, graph::Place::Behind), {1, {1}}),
            "the element was not found in the network");
  EXPECT_EQ(moved(2, at(2, graph::Place::Behind), {7, {1}}), "the network was not found");
}

TEST(Moves, TakeNetworksToAnotherPlace) {
  EXPECT_EQ(moved(1, at(-1, graph::Place::Before), {2}),
            "FUNCTION FC 1 : VOID\nVAR_TEMP\n  ready : BOOL;\nEND_VAR\nBEGIN\n"
            "NETWORK\nTITLE = two\n      O     E 1.0;\n      O     E 1.1;\n      SPB   M001;\n"
            "NETWORK\nTITLE = one\n// why\nM001: U     E 0.0; // first\n      U     #ready;\n"
            "      =     A 0.0;\n\nEND_FUNCTION\n");
  EXPECT_EQ(moved(1, at(-1, graph::Place::Behind), {1}), kJumping);
  EXPECT_EQ(moved(2, at(-1, graph::Place::Behind), {1}, kTwoOfStep5, kStep5),
            "PB 1\n"
            "NETZWERK 1  two\n      U     E 0.1\n      =     A 0.1\n"
            "NETZWERK 2  one\n      U     E 0.0\n      =     A 0.0\n"
            "      BE\n");
}

}  // namespace
}  // namespace merker::networks
