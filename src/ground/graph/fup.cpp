#include "graph/fup.h"

#include "graph/box_frame.h"
#include "graph/branches.h"

namespace merker::graph {
namespace {

Picture wire() {
  Picture out;
  out.w = 2;
  out.h = 1;
  out.in = 0;
  out.wire(0, 0, 2);
  return out;
}

class Diagram {
 public:
  explicit Diagram(const Style& style) : style_(style) {}

  Picture draw(const Network& network) const {
    Picture picture;
    for (const auto& root : paths(network)) {
      if (picture.h > 0) picture.h += kGap;
      picture.place(path(*root), 0, picture.h);
    }
    return picture;
  }

 private:
  // The signal of a node as what a box has at one of its pins.
  FramePin pin(const Node& node) const {
    switch (node.kind) {
      case NodeKind::Contact:
        if (node.continues) return {.logic = wire(), .negated = node.negated};
        return {.text = node.operand.text, .negated = node.negated};
      case NodeKind::Series:
        return series(node);
      case NodeKind::Parallel:
        return gate(">=1", pins(node.children), node.first);
      case NodeKind::Xor:
        return gate("XOR", pins(node.children), node.first);
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

  std::vector<FramePin> pins(const std::vector<Node>& nodes) const {
    std::vector<FramePin> out;
    for (const Node& node : nodes) out.push_back(pin(node));
    return out;
  }

  static FramePin gate(const char* title, std::vector<FramePin> inputs, std::size_t statement) {
    FrameText text;
    text.title = title;
    text.left = std::move(inputs);
    text.right = {{}};
    text.outLast = true;
    text.statement = statement;
    return {.logic = frame(text)};
  }

  // NOT, edges and connectors stand behind an AND of what is before them.
  FramePin series(const Node& node) const {
    std::vector<FramePin> inputs;
    const auto signal = [&inputs, &node] {
      FramePin out = inputs.size() == 1 ? inputs.front() : gate("&", inputs, node.first);
      inputs.clear();
      return out;
    };
    for (const Node& child : node.children) {
      if (child.kind == NodeKind::Not) {
        FramePin turned = signal();
        turned.negated = !turned.negated;
        inputs.push_back(std::move(turned));
      } else if (child.kind == NodeKind::Edge) {
        inputs.push_back(
            small(child.falling ? "N" : "P", child.memory.text, signal(), child.first));
      } else if (child.kind == NodeKind::Connector) {
        inputs.push_back(small("#", child.operand.text, signal(), child.first));
      } else {
        inputs.push_back(pin(child));
      }
    }
    return signal();
  }

  static FramePin small(const char* title, const std::string& above, FramePin input,
                        std::size_t statement) {
    FrameText text;
    text.above = above;
    text.left = {std::move(input)};
    text.left.front().name = title;
    text.right = {{}};
    text.statement = statement;
    return {.logic = frame(text)};
  }

  static FramePin operandEdge(const Node& node) {
    FrameText text;
    text.above = node.operand.text;
    text.title = node.falling ? "NEG" : "POS";
    text.left = {{.name = "M_BIT", .text = node.memory.text}};
    text.right = {{.name = "Q"}};
    text.statement = node.first;
    return {.logic = frame(text)};
  }

  FramePin box(const Node& box) const {
    const DrawPin draw = [this](const Node& logic) { return pin(logic); };
    return {.logic = frame(boxFrame(box, style_, draw))};
  }

  Picture coil(const Coil& coil, std::optional<FramePin> signal) const {
    const ElementRow& row = coil.element->row;
    FrameText text;
    text.above = coil.operand.text;
    text.statement = coil.first;
    text.hasOut = false;
    FramePin first = signal ? std::move(*signal) : FramePin{};
    first.name = style_.language == Language::German ? row.fup : row.fupEnglish;
    text.left.push_back(std::move(first));
    for (const Operand& value : coil.values) text.left.push_back({.text = value.text});
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
      out.add({ShapeKind::Text, 0, 0, out.w - 1, 0, signal.text, 0});
      out.wire(out.w - 1, 0, 1);
    }
    if (signal.negated) out.add({ShapeKind::Negation, out.w++, out.out, 1, 0, {}, 0});
    return out;
  }

  Picture path(const Path& path) const {
    std::optional<FramePin> signal;
    if (!path.logic.empty()) signal = pin(path.logic.front());
    if (path.tails.empty() && path.coils.size() == 1) return coil(path.coils.front(), signal);
    Picture before = signal ? picture(*signal) : Picture{};
    std::vector<Picture> parts;
    for (const auto& tail : path.tails) parts.push_back(this->path(*tail));
    for (const Coil& coil : path.coils)
      parts.push_back(this->coil(coil, FramePin{.logic = wire()}));
    return parts.empty() ? before : attached(before, parts);
  }

  const Style& style_;
};

}  // namespace

Picture fup(const Network& network, const Style& style) { return Diagram(style).draw(network); }

}  // namespace merker::graph
