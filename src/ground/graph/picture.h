// A drawing on a grid of characters: one column is one character, one row one line. The same grid
// becomes text and SVG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "graph/reason.h"
#include "graph/selection.h"

namespace merker::graph {

enum class ShapeKind : std::uint8_t {
  Wire,      // from (x, y), `w` columns to the right or `h` rows down
  Rail,      // as a wire down: what the current comes from
  Frame,     // of a box: corners at (x, y) and (x + w - 1, y + h - 1)
  Text,      // begins at (x, y)
  Contact,   // three columns at (x, y); text: "", "/" or "NOT"
  Coil,      // text between its brackets: "", "S", "#"
  Negation,  // one column: the signal is turned round where it enters a box
  Field      // where an operand or logic can be put that is not there; nothing is drawn
};

// The signal of a wire is 1 if all of these status bits are; with none it is power.
enum class FlowBit : std::uint8_t { Vke, Sta, NotSta };
struct Flow {
  std::size_t statement = 0;
  FlowBit bit = FlowBit::Vke;
  bool operator==(const Flow&) const = default;
};
using Flows = std::vector<Flow>;
// More than anybody draws in one branch. Of a longer list only so much is kept that it is known to
// be longer: the signal is not known.
constexpr std::size_t kMostFlows = 64;
inline bool isKnown(const Flows& flows) { return flows.size() <= kMostFlows; }

// Where a wire to the right begins and ends: at the edges of its columns, or in the middle of the
// first or the last one, where a wire goes down.
enum class Ends : std::uint8_t { AtEdges, BeginsInside, EndsInside };

struct Shape {
  ShapeKind kind = ShapeKind::Wire;
  int x = 0, y = 0, w = 0, h = 0;
  std::string text;
  std::size_t statement = 0;
  Ends ends = Ends::AtEdges;
  // Whose shape it is; of.pin: an operand field of it. A wire where branches end is their group's.
  Selection of = {};
  Flows flow = {};  // Wire, Negation
  bool value =
      false;  // Wire: what it carries is no signal; Text: AKKU 1 of `statement` is its value
  std::string whole = {};  // Text: the operand of which it shows a part
};

// Part of a drawing with the rows at which the signal comes in at its left and goes out at its
// right. `in` -1: it begins here, at the rail or with operands.
struct Picture {
  int w = 0, h = 0, in = -1, out = 0;
  std::vector<Shape> shapes = {};
  Flows flow = {};  // the signal that goes on, which the next wires get

  void add(Shape shape);
  void wire(int x, int y, int columns, Ends ends = Ends::AtEdges);
  void down(int x, int y, int rows);
  // The shapes of another picture, moved.
  void place(const Picture& other, int x, int y);
};

// Gives the first part the signal of `before`; the others branch off below it.
Picture attached(const Picture& before, const std::vector<Picture>& parts);
// What `attached` is wider than both together.
constexpr int kJoint = 1;
// Rows between rungs.
constexpr int kGap = 1;

// Characters that a text takes.
int columns(std::string_view text);

// The drawing as lines, without blanks at their ends. Refused if it has more cells than anybody
// reads: nothing is left out.
constexpr std::int64_t kMostCells = 250'000;
Result<std::vector<std::string>, Reason> toText(const Picture& picture);
// A whole document.
std::string toSvg(const Picture& picture, std::string_view title);

}  // namespace merker::graph
