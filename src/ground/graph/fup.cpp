#include "graph/fup.h"

#include "graph/box_frame.h"
#include "graph/branches.h"
#include "graph/flow.h"
#include "graph/kinds.h"

namespace merker::graph {
namespace {

Picture wire(const Flows& flow) {
  Picture out;
  out.flow = flow;
  out.w = 2;
  out.h = 1;
  out.in = 0;
  out.wire(0, 0, 2);
  return out;
}

constexpr int kLead = 1;  // columns from a box to where its signal branches

class Diagram {
 public:
  explicit Diagram(const Style& style) : style_(style) {}

  Picture draw(const Network& network) {
    Picture picture;
    for (const auto& root : paths(network)) {
      if (picture.h > 0) picture.h += kGap;
      picture.place(path(*root), 0, picture.h);
    }
    return picture;
  }

 private:
  // The signal of a node as what a box has at one of its pins.
  FramePin pin(const Node& node) {
    const bool group = isGroup(node);
    Signals outer = group ? signals_.enter(node) : signals_;
    FramePin out = drawn(node, outer);
    if (group)
      signals_.leave(node, std::move(outer));
    else
      signals_.pass(node);
    return out;
  }

  // What a contact gives its gate is its own bit, whatever stands before it.
  static Flows bit(const Node& contact) {
    return {{contact.last - 1, contact.negated ? FlowBit::NotSta : FlowBit::Sta}};
  }

  FramePin drawn(const Node& node, const Signals& outer) {
    switch (node.kind) {
      case NodeKind::Contact:
        if (node.continues)
          return {.logic = wire({{node.last - 1, FlowBit::Sta}}),
                  .negated = node.negated,
                  .flow = bit(node)};
        return {.text = node.operand.text,
                .negated = node.negated,
                .field = kOwn,
                .flow = bit(node),
                .before = {{node.last - 1, FlowBit::Sta}},
                .of = {selectionOf(node).node, kOwn}};
      case NodeKind::Series:
        return series(node);
      case NodeKind::Parallel:
        return gate(">=1", node, outer);
      case NodeKind::Xor:
        return gate("XOR", node, outer);
      case NodeKind::OperandEdge:
        return operandEdge(node);
      case NodeKind::Box:
        return box(node);
      case NodeKind::Not:
      case NodeKind::Edge:
      case NodeKind::Connector:
        break;
    }
    return {};
  }

  FramePin gate(const char* title, const Node& node, const Signals& outer) {
    std::vector<FramePin> inputs;
    for (const Node& child : node.children) {
      signals_.branch(outer);
      inputs.push_back(pin(child));
    }
    Signals behind = outer;
    behind.pass(node);
    return gate(title, std::move(inputs), node.first, selectionOf(node), behind.now());
  }

  static FramePin gate(const char* title, std::vector<FramePin> inputs, std::size_t statement,
                       const Selection& of, const Flows& flow) {
    FrameText text;
    text.of = of;
    text.flow = flow;
    text.title = title;
    text.left = std::move(inputs);
    text.right = {{}};
    text.outLast = true;
    text.statement = statement;
    return {.logic = frame(text)};
  }

  // NOT, edges and connectors stand behind an AND of what is before them.
  FramePin series(const Node& node) {
    std::vector<FramePin> inputs;
    const Node* last = nullptr;
    const auto signal = [&] {
      const Selection of = node.bracketed && last == &node.children.back()
                               ? selectionOf(node)
                               : Selection{last == nullptr ? -1 : selectionOf(*last).node, kNoPin,
                                           static_cast<int>(node.first)};
      FramePin out =
          inputs.size() == 1 ? inputs.front() : gate("&", inputs, node.first, of, signals_.now());
      inputs.clear();
      return out;
    };
    for (const Node& child : node.children) {
      if (child.kind == NodeKind::Not) {
        FramePin turned = signal();
        turned.negated = !turned.negated;
        signals_.pass(child);
        turned.flow = signals_.now();
        inputs.push_back(std::move(turned));
      } else if (child.kind == NodeKind::Edge) {
        inputs.push_back(small(child.falling ? "N" : "P", child.memory.text, signal(), child));
      } else if (child.kind == NodeKind::Connector) {
        inputs.push_back(small("#", child.operand.text, signal(), child));
      } else {
        inputs.push_back(pin(child));
      }
      last = &child;
    }
    return signal();
  }

  FramePin small(const char* title, const std::string& above, FramePin input, const Node& node) {
    signals_.pass(node);
    FrameText text;
    text.of = selectionOf(node);
    text.flow = signals_.now();
    text.above = above;
    text.left = {std::move(input)};
    text.left.front().name = title;
    text.right = {{}};
    text.statement = node.first;
    return {.logic = frame(text)};
  }

  FramePin operandEdge(const Node& node) const {
    FrameText text;
    text.above = node.operand.text;
    text.title = node.falling ? "NEG" : "POS";
    text.left = {{.name = "M_BIT", .text = node.memory.text, .field = kFirstPin, .value = true}};
    text.right = {{.name = "Q"}};
    text.statement = node.first;
    text.of = selectionOf(node);
    text.flow = {{node.last - 1, FlowBit::Vke}};
    return {.logic = frame(text)};
  }

  FramePin box(const Node& box) {
    const Signals here = signals_;
    const DrawPin draw = [this](const Node& logic) {
      signals_.begin();
      return pin(logic);
    };
    FrameText text = boxFrame(box, style_, draw);
    signals_ = here;
    text.flow = {{box.last - 1, FlowBit::Vke}};
    return {.logic = frame(text)};
  }

  Picture coil(const Coil& coil, std::optional<FramePin> signal) const {
    const ElementRow& row = coil.element->row;
    FrameText text;
    text.above = coil.operand.text;
    text.statement = coil.first;
    text.of = selectionOf(coil);
    text.hasOut = false;
    FramePin first = signal ? std::move(*signal) : FramePin{};
    first.name = style_.names == Language::German ? row.fup : row.fupEnglish;
    text.left.push_back(std::move(first));
    int field = kFirstPin;
    for (const Operand& value : coil.values)
      text.left.push_back(
          {.text = value.text,
           .field = field++,
           .value = true,
           .moved = coil.first + static_cast<std::size_t>(&value - coil.values.data())});
    return frame(text);
  }

  // Paths

  // A signal that goes to several places.
  static Picture picture(const FramePin& signal) {
    Picture out;
    if (signal.logic) {
      out = *signal.logic;
    } else {
      out.w = columns(signal.text) + 1;
      out.h = 1;
      out.flow = signal.flow;
      out.add({ShapeKind::Text, 0, 0, out.w - 1, 0, signal.text, 0, Ends::AtEdges, signal.of});
      out.wire(out.w - 1, 0, 1);
    }
    if (signal.negated)
      out.add({ShapeKind::Negation, out.w++, out.out, 1, 0, {}, 0, Ends::AtEdges, {}, signal.flow});
    return out;
  }

  Picture path(const Path& path) {
    std::optional<FramePin> signal;
    signals_.begin();
    if (!path.logic.empty()) signal = pin(path.logic.front());
    const Flows flow = signals_.now();
    if (path.tails.empty() && path.coils.size() == 1) return coil(path.coils.front(), signal);
    Picture before = signal ? picture(*signal) : Picture{};
    before.flow = flow;
    std::vector<Picture> parts;
    for (const Coil& coil : path.coils)
      parts.push_back(this->coil(coil, FramePin{.logic = wire(flow)}));
    for (const auto& tail : path.tails) parts.push_back(this->path(*tail));
    if (parts.empty()) return before;
    if (signal && (signal->logic || signal->negated)) before.wire(before.w++, before.out, kLead);
    return attached(before, parts);
  }

  const Style& style_;
  Signals signals_;
};

}  // namespace

Picture fup(const Network& network, const Style& style) { return Diagram(style).draw(network); }

}  // namespace merker::graph
