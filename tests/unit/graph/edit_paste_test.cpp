// Elements that are copied, cut, moved and put in somewhere else.
#include <algorithm>

#include "edits.h"
#include "graph/kop.h"
#include "graph5/rules.h"

namespace merker::graph {
namespace {

using namespace edits;

std::string copyOf(const std::string& network, const std::vector<std::string>& elements,
                   const Rules& rules = graph7::rules()) {
  std::vector<Selection> selections;
  for (const std::string& element : elements) selections.push_back(selection(element));
  const auto copied = copy(networkOf(network, rules), selections, rules, kFirstWire);
  return copied ? test::text(*copied) : std::string(text(copied.error(), Language::English));
}

Edit paste(const std::string& at, Place place, const std::string& what) {
  Edit edit = act(Action::Paste, at);
  edit.place = place;
  edit.pasted = networkOf(what, graph7::rules(), Unfinished::Part);
  return edit;
}
Edit move(const std::string& from, const std::string& at, Place place) {
  Edit edit = act(Action::Move, at);
  edit.from = selection(from);
  edit.place = place;
  return edit;
}

constexpr const char* kFlipFlop = "U E 0.0; S M 1.0; U E 0.1; R M 1.0; U M 1.0; = A 0.0";
constexpr const char* kBranched =
    "U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; BLD 102; = A 0.1";

TEST(Copies, AreElementsAlone) {
  const struct {
    std::string network;
    std::vector<std::string> elements;
    std::string copy;
  } rows[] = {
      {"O E 0.0; ON E 0.1; = A 0.0", {"1"}, "UN E 0.1"},
      {"O E 0.0; O E 0.1; = A 0.0", {"0-1"}, "O E 0.0; O E 0.1"},
      {"U(; O E 0.0; O E 0.1; ); U E 0.2; = A 0.0", {"3"}, "O E 0.0; O E 0.1"},
      {"U E 0.0; U E 0.1; = A 0.0", {"1", "0", "2"}, "U E 0.0; U E 0.1; = A 0.0"},
      {"U E 0.0; = A 0.0", {"1"}, "= A 0.0"},
      {"U E 0.0; = A 0.0; S A 0.1", {"1", "2"}, "= A 0.0; S A 0.1"},
      {"U E 0.0; FP M 1.0; = A 0.0", {"1"}, "U ??.?; FP M 1.0"},
      {kFlipFlop, {"4"}, "U ??.?; S M 1.0; U E 0.1; R M 1.0; NOP"},
      {"U E 0.0; SPBNB ->4; L MW 1; T MW 2; NOP", {"4"}, "L MW 1; T MW 2; NOP"},
      {kBranched, {"0", "3"}, "U E 0.0; U E 0.1"},
      {"U E 0.0; = A 0.0", {"7"}, "the element was not found in the network"},
  };
  for (const auto& row : rows) EXPECT_EQ(copyOf(row.network, row.elements), row.copy);
}

TEST(Pastes, GoWhereElementsAreInserted) {
  const std::string or2 = "O E 1.0; O E 1.1";
  expectAll({
      {"U E 0.0; = A 0.0", paste("0", kBehind, "UN E 0.1"), "U E 0.0; UN E 0.1; = A 0.0 [1:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kParallel, "U E 0.1; U E 0.2"),
       "O E 0.0; O; U E 0.1; U E 0.2; = A 0.0 [3:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kBefore, or2),
       "U(; O E 1.0; O E 1.1; ); U E 0.0; = A 0.0 [3:-1]"},
      {"U E 0.0; = A 0.0", paste("1", kBehind, or2),
       "U E 0.0; U(; O E 1.0; O E 1.1; ); = A 0.0 [4:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kBehind, "U ??.?; FP M 1.0"),
       "U E 0.0; FP M 1.0; = A 0.0 [1:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kBehind, "U E 0.1; NOT"),
       "U E 0.0; U E 0.1; NOT; = A 0.0 [2:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kBefore, "U ??.?; NOT"),
       "refused: there must be logic before this element"},
      {"U E 0.0; = A 0.0", paste("0", kBehind, "U E 0.2; S M 1.0; U E 0.1; R M 1.0; NOP"),
       "U E 0.0; U E 0.2; S M 1.0; U E 0.1; R M 1.0; U M 1.0; = A 0.0 [5:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kBehind, "L MW 1; T MW 2; NOP"),
       "U E 0.0; SPBNB ->7; L MW 1; T MW 2; SET; SAVE; CLR; U BIE; = A 0.0 [7:-1]"},
      {"", paste("", kBehind, or2), "O E 1.0; O E 1.1 [1:-1]"},
      {kFlipFlop, paste("4:2", kAtPin, "U E 0.2"),
       "U E 0.0; S M 1.0; U E 0.1; U E 0.2; R M 1.0; U M 1.0; = A 0.0 [3:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kBehind, ""), "refused: the element is unknown"},
  });
}

TEST(Pastes, PutCoilsBesideCoilsAndRungsBelow) {
  expectAll({
      {"U E 0.0; = A 0.0", paste("1", kBehind, "S A 0.1"), "U E 0.0; = A 0.0; S A 0.1 [2:-1]"},
      {"U E 0.0; = A 0.0; = A 0.3", paste("1", kBehind, "S A 0.1; R A 0.2"),
       "U E 0.0; = A 0.0; S A 0.1; R A 0.2; = A 0.3 [3:-1]"},
      {"U E 0.0; = A 0.0", paste("0", kBehind, "U E 0.1; = A 0.1"),
       "U E 0.0; = A 0.0; U E 0.1; = A 0.1 [3:-1]"},
      {"U E 0.0; = A 0.0", paste("1", kBehind, "SPA ???"), "U E 0.0; = A 0.0; SPB ??? [2:0]"},
      // Each has its own temporary bits.
      {kBranched, paste("0", kBehind, kBranched),
       "U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; BLD 102; = A 0.1; "
       "U E 0.0; = L 20.1; U L 20.1; U E 0.1; = A 0.0; U L 20.1; BLD 102; = A 0.1 [15:-1]"},
      {kBranched, paste("0", kBehind, "U L 20.0; = A 0.2"),
       "U E 0.0; = L 20.0; U L 20.0; U E 0.1; = A 0.0; U L 20.0; BLD 102; = A 0.1; "
       "U ??.?; = A 0.2 [9:-1]"},
  });
}

TEST(Moves, TakeTheElementWithThem) {
  expectAll({
      {"U E 0.0; U E 0.1; = A 0.0", move("0", "1", kBehind), "U E 0.1; U E 0.0; = A 0.0 [1:-1]"},
      {"U E 0.0; U E 0.1; = A 0.0", move("0", "1", kParallel), "O E 0.1; O E 0.0; = A 0.0 [1:-1]"},
      {"O E 0.0; O E 0.1; = A 0.0", move("1", "2", kBehind), "U E 0.0; U E 0.1; = A 0.0 [1:-1]"},
      {"O E 0.0; O E 0.1; U E 0.2; = A 0.0", move("2", "3", kBehind),
       "U(; O E 0.0; O E 0.1; ); U E 0.2; = A 0.0 [4:-1]"},
      {"U E 0.0; = A 0.0; U E 0.1; = A 0.1", move("0", "2", kBehind),
       "U ??.?; = A 0.0; U E 0.1; U E 0.0; = A 0.1 [3:-1]"},
      {"U E 0.0; = A 0.0; U E 0.1; = A 0.1", move("1", "3", kBehind),
       "U E 0.0; = ??.?; U E 0.1; = A 0.1; = A 0.0 [4:-1]"},
      // What comes to a box stays.
      {"U E 0.0; S M 1.0; U E 0.1; R M 1.0; U M 1.0; = A 0.0; U E 0.2; = A 0.1",
       move("4", "6", kBehind),
       "U E 0.0; = A 0.0; U E 0.2; S M 1.0; U E 0.1; R M 1.0; U M 1.0; = A 0.1 [6:-1]"},
      {"U E 0.0; U E 0.1; NOT; U E 0.2; = A 0.0", move("0-2", "3", kBehind),
       "U E 0.2; U(; U E 0.0; U E 0.1; NOT; ); = A 0.0 [5:-1]"},
  });
}

TEST(Moves, LoseNothing) {
  const std::string refused = "refused: ";
  expectAll({
      {"U E 0.0; U E 0.1; = A 0.0", move("0", "0", kBehind), "U E 0.0; U E 0.1; = A 0.0 [-1:-1]"},
      {"O E 0.0; O E 0.1; = A 0.0", move("0-1", "0", kBehind),
       refused + "an element cannot be moved into itself"},
      {kFlipFlop, move("4", "2", kBehind), refused + "an element cannot be moved into itself"},
      {kBranched, move("0-2", "4", kBehind),
       refused + "an element from which a branch goes out cannot be moved"},
      {"U E 0.0; = A 0.0", move("0", "7", kBehind),
       refused + "the element was not found in the network"},
      {"U E 0.0; = A 0.0", move("7", "0", kBehind),
       refused + "the element was not found in the network"},
      {"U E 0.0; = A 0.0", move("1", "7", kBehind),
       refused + "the element was not found in the network"},
      {"U E 0.0; FP M 1.0; = A 0.0", move("1", "0", kBefore),
       refused + "there must be logic before this element"},
  });
}

TEST(Deletions, LeaveWhatComesToABox) {
  expectAll({
      {kFlipFlop, act(Action::Delete, "4"), "U E 0.0; = A 0.0 [0:-1]"},
      {"U E 0.0; SPBNB ->4; L MW 1; T MW 2; NOP", act(Action::Delete, "4"), "U E 0.0 [0:-1]"},
      {"L MW 1; T MW 2; NOP", act(Action::Delete, "2"), " [-1:-1]"},
  });
}

// The wires at the end of branches are those of their group: what is dropped there stands behind
// it.
TEST(Pictures, NameTheWiresWhereBranchesEnd) {
  const Picture picture = kop(networkOf("O E 0.0; O E 0.1; = A 0.0"), {});
  EXPECT_EQ(std::count_if(picture.shapes.begin(), picture.shapes.end(),
                          [](const Shape& shape) {
                            return shape.kind == ShapeKind::Wire && shape.of == Selection{1, -1, 0};
                          }),
            3);
}

}  // namespace
}  // namespace merker::graph
