#include "graph/ladder_elements.h"

#include <algorithm>

#include "graph/box_frame.h"
#include "graph/branches.h"
#include "graph/kinds.h"
#include "graph/ladder_parts.h"

namespace merker::graph {
namespace {

constexpr int kBlank = 1;  // left of the operands of a box: the rail, or what stands before it

}  // namespace

// Between the signal at which it stands and the one behind it; `least` columns of text have room.
Picture LadderElements::symbol(ShapeKind kind, const std::string& text, const std::string& above,
                               std::size_t statement, const Selection& of, const Flows& behind,
                               int least) {
  Picture out;
  out.flow = signals_.now();
  const int inside = std::max(3, columns(text) + 2);
  const int textWidth = columns(above);
  out.w = std::max(inside + 4, std::max(textWidth, least) + 2);
  out.h = 2;
  out.in = out.out = 1;
  const int at = (out.w - inside) / 2;
  const Selection operand{of.node, kOwn};
  if (textWidth > 0)
    out.add({ShapeKind::Text, (out.w - textWidth) / 2, 0, textWidth, 0, above, statement,
             Ends::AtEdges, operand});
  out.wire(0, 1, at);
  out.add({kind, at, 1, inside, 0, text, statement, Ends::AtEdges, of});
  out.flow = behind;
  out.wire(at + inside, 1, out.w - at - inside);
  return out;
}

Picture LadderElements::symbol(ShapeKind kind, const std::string& text, const std::string& above,
                               const Node& node) {
  Signals behind = signals_;
  behind.pass(node);
  return symbol(kind, text, above, node.first, selectionOf(node), behind.now());
}

// Where the signal is behind it.
Picture LadderElements::node(const Node& node, Begin begin) {
  if (isGroup(node)) {
    Signals outer = signals_.enter(node);
    Picture out =
        node.kind == NodeKind::Series ? series(node, begin) : parallel(node, outer, begin);
    signals_.leave(node, std::move(outer));
    out.flow = signals_.now();
    return out;
  }
  // A branch goes on with what its temporary bit holds.
  if (node.continues && node.kind == NodeKind::Contact)
    signals_.beginAt({{node.last - 1, FlowBit::Sta}});
  Picture out = single(node, begin);
  signals_.pass(node);
  out.flow = signals_.now();
  return out;
}

Picture LadderElements::single(const Node& node, Begin begin) {
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
      return box(node, begin);
  }
  return {};
}

Picture LadderElements::wire() const {
  Picture out;
  out.flow = signals_.now();
  out.w = 2;
  out.h = 1;
  out.in = out.out = 0;
  out.wire(0, 0, 2);
  return out;
}

Picture LadderElements::negation(const Node& node) {
  return symbol(ShapeKind::Contact, "NOT", "", node);
}

Picture LadderElements::operandEdge(const Node& node) {
  FrameText text;
  text.above = node.operand.text;
  text.title = node.falling ? "NEG" : "POS";
  text.left = {{}, {.name = "M_BIT", .text = node.memory.text, .field = kFirstPin, .value = true}};
  text.right = {{.name = "Q"}};
  text.statement = node.first;
  text.of = selectionOf(node);
  text.flow = behind(node);
  text.blank = kBlank;
  return through(frame(text), signals_.now());
}

Flows LadderElements::behind(const Node& node) const {
  Signals signals = signals_;
  signals.pass(node);
  return signals.now();
}

// The logic of the first pin goes on from where the box stands, that of the others from the rail.
Picture LadderElements::box(const Node& box, Begin begin) {
  const Signals here = signals_;
  bool first = true;
  const DrawPin draw = [&](const Node& logic) {
    signals_.beginAt(first ? here.now() : Flows{});
    first = false;
    FramePin pin;
    pin.logic = node(logic, begin);
    return pin;
  };
  FrameText text = boxFrame(box, style_, draw);
  signals_ = here;
  text.flow = behind(box);
  text.blank = kBlank;
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

Picture LadderElements::series(const Node& series, Begin begin) {
  std::vector<Picture> parts;
  for (const Node& child : series.children)
    parts.push_back(node(child, parts.empty() ? begin : Begin::Inside));
  return beside(parts);
}

// Its branches below each other, joined at both ends; at the left the rail may do that.
Picture LadderElements::parallel(const Node& parallel, const Signals& outer, Begin begin) {
  std::vector<Picture> parts;
  int widest = 0;
  const int joint = begin == Begin::AtRail ? 0 : 1;
  parallels_ += joint;
  for (const Node& child : parallel.children) {
    signals_.branch(outer);
    parts.push_back(node(child, begin));
    widest = std::max(widest, parts.back().w);
  }
  parallels_ -= joint;
  Picture out;
  std::vector<int> rowsIn, rowsOut;
  for (const Picture& part : parts) {
    const int y = out.h;
    out.place(part, joint, y);
    rowsIn.push_back(y + std::max(part.in, 0));
    rowsOut.push_back(y + part.out);
    out.flow = part.flow;
    out.wire(joint + part.w, rowsOut.back(), widest - part.w);
  }
  out.w = joint + widest + 1;
  out.flow = outer.now();
  for (const int row : rowsIn)
    out.wire(0, row, joint, row == rowsIn.front() ? Ends::AtEdges : Ends::BeginsInside);
  if (joint > 0) out.down(0, rowsIn.front(), rowsIn.back() - rowsIn.front());
  Signals behind = outer;
  behind.pass(parallel);
  out.flow = behind.now();
  const std::size_t closing = out.shapes.size();
  for (const int row : rowsOut)
    out.wire(out.w - 1, row, 1, row == rowsOut.front() ? Ends::AtEdges : Ends::EndsInside);
  out.down(out.w - 1, rowsOut.front(), rowsOut.back() - rowsOut.front());
  for (std::size_t i = closing; i < out.shapes.size(); ++i)
    out.shapes[i].of = selectionOf(parallel);
  out.in = rowsIn.front();
  out.out = rowsOut.front();
  return out;
}

Picture LadderElements::coil(const Coil& coil) {
  const ElementRow& row = coil.element->row;
  std::string name(style_.names == Language::German ? row.kop : row.kopEnglish);
  name = name.size() > 2 ? name.substr(1, name.size() - 2) : "";
  int widest = 0;
  for (const Operand& value : coil.values) widest = std::max(widest, columns(value.text));
  Picture out = symbol(ShapeKind::Coil, name == " " ? "" : name, coil.operand.text, coil.first,
                       selectionOf(coil), signals_.now(), widest);
  int field = kFirstPin;
  std::size_t loaded = coil.first;  // one statement each, before that of the coil
  for (const Operand& value : coil.values) {
    const int width = columns(value.text);
    out.add({ShapeKind::Text,
             (out.w - width) / 2,
             out.h++,
             width,
             0,
             value.text,
             loaded++,
             Ends::AtEdges,
             {selectionOf(coil).node, field++},
             {},
             true});
  }
  return out;
}

}  // namespace merker::graph
