#include "graph/kop.h"

#include <algorithm>

#include "graph/box_frame.h"
#include "graph/branches.h"
#include "graph/flow.h"
#include "graph/kinds.h"
#include "graph/ladder_parts.h"

namespace merker::graph {
namespace {

class Ladder {
 public:
  explicit Ladder(const Style& style) : style_(style) {}

  Picture draw(const Network& network) {
    Picture picture;
    const auto roots = paths(network);
    int width = 0, bottom = 0;
    for (const auto& root : roots) width = std::max(width, widthOfRung(*root));
    lines_ = 0;
    for (const auto& root : roots) {
      const Picture rung = this->rung(*root, width);
      picture.place(rung, 1, picture.h);
      bottom = picture.h;
      picture.h += kGap;
    }
    picture.add({ShapeKind::Rail, 0, 0, 0, std::max(bottom - 1, 1), {}, 0});
    picture.h = std::max(bottom, 2);
    return picture;
  }

 private:
  // Logic, coils

  // Between the signal at which it stands and the one behind it.
  Picture symbol(ShapeKind kind, const std::string& text, const std::string& above,
                 std::size_t statement, const Selection& of, const Flows& behind) {
    Picture out;
    out.flow = signals_.now();
    const int inside = std::max(3, columns(text) + 2);
    const int textWidth = columns(above);
    out.w = std::max(inside + 4, textWidth + 2);
    out.h = 2;
    out.in = out.out = 1;
    const int at = (out.w - inside) / 2;
    out.add({ShapeKind::Text,
             (out.w - textWidth) / 2,
             0,
             textWidth,
             0,
             above,
             statement,
             Ends::AtEdges,
             {of.node, kOwn}});
    out.wire(0, 1, at);
    out.add({kind, at, 1, inside, 0, text, statement, Ends::AtEdges, of});
    out.flow = behind;
    out.wire(at + inside, 1, out.w - at - inside);
    return out;
  }

  Picture symbol(ShapeKind kind, const std::string& text, const std::string& above,
                 const Node& node) {
    Signals behind = signals_;
    behind.pass(node);
    return symbol(kind, text, above, node.first, selectionOf(node), behind.now());
  }

  // Where the signal is behind it.
  Picture node(const Node& node) {
    if (isGroup(node)) {
      Signals outer = signals_.enter(node);
      Picture out = node.kind == NodeKind::Series ? series(node) : parallel(node, outer);
      signals_.leave(node, std::move(outer));
      out.flow = signals_.now();
      return out;
    }
    // A branch goes on with what its temporary bit holds.
    if (node.continues && node.kind == NodeKind::Contact)
      signals_.beginAt({{node.last - 1, FlowBit::Sta}});
    Picture out = single(node);
    signals_.pass(node);
    out.flow = signals_.now();
    return out;
  }

  Picture single(const Node& node) {
    switch (node.kind) {
      case NodeKind::Series:
      case NodeKind::Parallel:
      case NodeKind::Xor:
        break;
      case NodeKind::Contact:
        if (node.continues) return node.negated ? negation(node) : wire();
        return symbol(ShapeKind::Contact, node.negated ? "/" : "", node.operand.text, node);
      case NodeKind::Not:
        return negation(node);
      case NodeKind::Edge:
        return symbol(ShapeKind::Coil, node.falling ? "N" : "P", node.memory.text, node);
      case NodeKind::OperandEdge:
        return operandEdge(node);
      case NodeKind::Connector:
        return symbol(ShapeKind::Coil, "#", node.operand.text, node);
      case NodeKind::Box:
        return box(node);
    }
    return {};
  }

  Picture wire() const {
    Picture out;
    out.flow = signals_.now();
    out.w = 2;
    out.h = 1;
    out.in = out.out = 0;
    out.wire(0, 0, 2);
    return out;
  }

  Picture negation(const Node& node) { return symbol(ShapeKind::Contact, "NOT", "", node); }

  Picture operandEdge(const Node& node) {
    FrameText text;
    text.above = node.operand.text;
    text.title = node.falling ? "NEG" : "POS";
    text.left = {{},
                 {.name = "M_BIT", .text = node.memory.text, .field = kFirstPin, .value = true}};
    text.right = {{.name = "Q"}};
    text.statement = node.first;
    text.of = selectionOf(node);
    text.flow = behind(node);
    return through(frame(text), signals_.now());
  }

  Flows behind(const Node& node) const {
    Signals signals = signals_;
    signals.pass(node);
    return signals.now();
  }

  // The logic of the first pin goes on from where the box stands, that of the others from the rail.
  Picture box(const Node& box) {
    const Signals here = signals_;
    bool first = true;
    const DrawPin draw = [&](const Node& logic) {
      signals_.beginAt(first ? here.now() : Flows{});
      first = false;
      FramePin pin;
      pin.logic = node(logic);
      return pin;
    };
    FrameText text = boxFrame(box, style_, draw);
    signals_ = here;
    text.flow = behind(box);
    if (box.element->row.kind == ElementClass::Compare) {
      text.left.insert(text.left.begin(), FramePin{});
      return through(frame(text), signals_.now());
    }
    const Node* contact = firstContact(box);
    const bool atBranch = contact != nullptr && contact->continues;
    for (std::size_t i = 1; i < text.left.size(); ++i)
      text.left[i].fromRail = (atBranch || parallels_ > 0) && text.left[i].logic.has_value();
    Picture out = frame(text);
    if (out.in < 0 && !text.left.empty() && !text.left.front().logic)
      return through(out, signals_.now());
    return out;
  }

  Picture series(const Node& series) {
    std::vector<Picture> parts;
    for (const Node& child : series.children) parts.push_back(node(child));
    return beside(parts);
  }

  // Its branches below each other, joined at both ends.
  Picture parallel(const Node& parallel, const Signals& outer) {
    std::vector<Picture> parts;
    int widest = 0;
    ++parallels_;
    for (const Node& child : parallel.children) {
      signals_.branch(outer);
      parts.push_back(node(child));
      widest = std::max(widest, parts.back().w);
    }
    --parallels_;
    Picture out;
    std::vector<int> rowsIn, rowsOut;
    for (const Picture& part : parts) {
      const int y = out.h;
      out.place(part, 1, y);
      rowsIn.push_back(y + std::max(part.in, 0));
      rowsOut.push_back(y + part.out);
      out.flow = part.flow;
      out.wire(1 + part.w, rowsOut.back(), widest - part.w);
    }
    out.w = widest + 2;
    out.flow = outer.now();
    for (const int row : rowsIn)
      out.wire(0, row, 1, row == rowsIn.front() ? Ends::AtEdges : Ends::BeginsInside);
    out.down(0, rowsIn.front(), rowsIn.back() - rowsIn.front());
    Signals behind = outer;
    behind.pass(parallel);
    out.flow = behind.now();
    for (const int row : rowsOut)
      out.wire(widest + 1, row, 1, row == rowsOut.front() ? Ends::AtEdges : Ends::EndsInside);
    out.down(widest + 1, rowsOut.front(), rowsOut.back() - rowsOut.front());
    out.in = rowsIn.front();
    out.out = rowsOut.front();
    return out;
  }

  Picture coil(const Coil& coil) {
    const ElementRow& row = coil.element->row;
    std::string name(style_.language == Language::German ? row.kop : row.kopEnglish);
    name = name.size() > 2 ? name.substr(1, name.size() - 2) : "";
    Picture out = symbol(ShapeKind::Coil, name == " " ? "" : name, coil.operand.text, coil.first,
                         selectionOf(coil), signals_.now());
    int field = kFirstPin;
    for (const Operand& value : coil.values) {
      const int width = columns(value.text);
      out.w = std::max(out.w, width);
      out.add({ShapeKind::Text,
               std::max(0, (out.w - width) / 2),
               out.h++,
               width,
               0,
               value.text,
               coil.first,
               Ends::AtEdges,
               {selectionOf(coil).node, field++}});
    }
    return out;
  }

  // Paths

  int widthBehind(const Path& path) {
    int behind = 0;
    for (const auto& tail : path.tails) behind = std::max(behind, kJoint + widthOf(*tail));
    for (const Coil& coil : path.coils) behind = std::max(behind, kJoint + this->coil(coil).w);
    return behind;
  }
  int widthOf(const Path& path) {
    return (path.logic.empty() ? 0 : node(path.logic.front()).w) + widthBehind(path);
  }
  int widthOfRung(const Path& path) {
    const Lines lines = linesOf(path);
    int width = lines.last.w + widthBehind(path);
    for (const Picture& line : lines.full) width = std::max(width, line.w);
    return width;
  }

  Picture path(const Path& path, int width) {
    signals_.begin();
    return ended(path.logic.empty() ? Picture{} : node(path.logic.front()), path, width);
  }

  Picture rung(const Path& path, int width) {
    const Lines lines = linesOf(path);
    Picture out;
    for (const Picture& line : lines.full) out.place(line, 0, out.h);
    out.place(ended(lines.last, path, width), 0, out.h);
    return out;
  }

  // `out` with what goes on behind it.
  Picture ended(Picture out, const Path& path, int width) {
    const Flows flow = signals_.now();
    const int left = width - out.w - kJoint;
    std::vector<Picture> parts;
    for (const Coil& coil : path.coils) parts.push_back(atEnd(this->coil(coil), left));
    for (const auto& tail : path.tails) parts.push_back(this->path(*tail, left));
    out.flow = flow;
    return parts.empty() ? out : attached(out, parts);
  }

  // Lines

  // The logic of a rung that is wider than the page.
  struct Lines {
    std::vector<Picture> full;  // each ends with a mark, with which the next one begins
    Picture last;
  };

  Lines linesOf(const Path& path) {
    Lines out;
    const int room = style_.widest - widthBehind(path) - 2 * kMark;
    signals_.begin();
    if (path.logic.empty()) return out;
    const Node& logic = path.logic.front();
    if (style_.widest == 0 || logic.kind != NodeKind::Series || logic.bracketed)
      out.last = node(logic);
    else
      wrap(logic, room, out);
    return out;
  }

  void wrap(const Node& series, int room, Lines& out) {
    Signals outer = signals_.enter(series);
    std::vector<Picture> parts;
    int width = 0;
    for (const Node& child : series.children) {
      const Flows before = signals_.now();
      Picture part = node(child);
      if (width > 0 && width + part.w > room) {
        parts.push_back(goesOn(++lines_, before));
        out.full.push_back(beside(parts));
        parts = {comesFrom(lines_, before)};
        width = 0;
      }
      width += part.w;
      parts.push_back(std::move(part));
    }
    signals_.leave(series, std::move(outer));
    out.last = beside(parts);
    out.last.flow = signals_.now();
  }

  const Style& style_;
  Signals signals_;
  int lines_ = 0;      // that go on below, so far
  int parallels_ = 0;  // around what is being drawn
};

}  // namespace

Picture kop(const Network& network, const Style& style) { return Ladder(style).draw(network); }

}  // namespace merker::graph
