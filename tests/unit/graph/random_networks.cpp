#include "random_networks.h"

#include <fmt/format.h>

namespace merker::graph::test {
namespace {

constexpr int kDeepest = 3;
constexpr std::uint32_t kOutputs = 1000;  // numbers of what coils, connectors and boxes are about

int below(int limit) { return *rc::gen::inRange(0, limit); }
bool maybe() { return below(2) == 1; }

class Maker {
 public:
  explicit Maker(const Rules& rules) : rules_(rules) {}

  Network network() {
    Network network;
    for (int count = 1 + below(3); count > 0; --count) network.rungs.push_back(rung());
    return network;
  }

 private:
  Rung rung() {
    Rung rung;
    if (const Element* rail = pick(ElementClass::RailCoil); rail != nullptr && below(8) == 0) {
      rung.coils.push_back(coil(*rail));
      return rung;
    }
    rung.logic.push_back(wires_.empty() || maybe() ? node(0) : fromWire());
    for (int count = below(3); count > 0; --count)
      rung.coils.push_back(coil(*pick(ElementClass::Coil)));
    return rung;
  }

  const Element* pick(ElementClass kind) const {
    std::vector<const Element*> some;
    for (const Element& element : rules_.elements->elements())
      if (element.row.kind == kind) some.push_back(&element);
    return some.empty() ? nullptr
                        : some[static_cast<std::size_t>(below(static_cast<int>(some.size())))];
  }

  Coil coil(const Element& element) {
    Coil out{&element, output(), {}, 0, 0};
    if (element.items.front().kind == ItemKind::Plain) out.operand = {};
    for (std::size_t i = 0; i < element.pins.size(); ++i) out.values.push_back(value());
    return out;
  }

  Node fromWire() {
    Node series, wire = contact();
    wire.negated = false;
    wire.operand = wires_[static_cast<std::size_t>(below(static_cast<int>(wires_.size())))];
    series.children.push_back(wire);
    if (maybe()) series.children.push_back(node(1));
    return series;
  }

  Node node(int depth) {
    switch (depth < kDeepest ? below(8) : 0) {
      case 1:
        return group(NodeKind::Series, depth);
      case 2:
        return group(NodeKind::Parallel, depth);
      case 3:
        return group(NodeKind::Xor, depth);
      case 4:
        return acting(depth);
      case 5:
        return box(depth);
      case 6:
        return edge();
      default:
        return contact();
    }
  }

  Node contact() {
    Node node;
    node.kind = NodeKind::Contact;
    node.negated = maybe();
    node.bracketed = maybe();
    node.operand = bit(static_cast<std::uint32_t>(below(8)));
    return node;
  }

  Node edge() {
    Node node;
    node.kind = rules_.deepestBrackets == 7 ? NodeKind::OperandEdge : NodeKind::Contact;
    node.falling = node.kind == NodeKind::OperandEdge && maybe();
    node.operand = bit(1);
    if (node.kind == NodeKind::OperandEdge) node.memory = output();
    return node;
  }

  Node group(NodeKind kind, int depth) {
    Node node;
    node.kind = kind;
    node.bracketed = maybe();
    for (int count = below(4); count > 0; --count) node.children.push_back(this->node(depth + 1));
    return node;
  }

  // Something, and what acts on it.
  Node acting(int depth) {
    Node series = group(NodeKind::Series, depth), last;
    constexpr NodeKind kKinds[] = {NodeKind::Not, NodeKind::Edge, NodeKind::Connector};
    last.kind = kKinds[below(3)];
    if (last.kind == NodeKind::Edge) last.memory = output();
    if (last.kind == NodeKind::Connector) {
      last.operand = maybe() ? output() : wire();
      if (last.operand.kind == OperandKind::Wire) wires_.push_back(last.operand);
    }
    series.children.push_back(last);
    if (maybe()) series.children.push_back(node(depth + 1));
    return series;
  }

  Node box(int depth) {
    constexpr ElementClass kKinds[] = {ElementClass::Compare, ElementClass::Box,
                                       ElementClass::Move};
    const Element* element = pick(kKinds[below(3)]);
    if (element == nullptr) return contact();
    Node node;
    node.kind = NodeKind::Box;
    node.element = element;
    node.pins.resize(element->pins.size());
    if (element->row.kind == ElementClass::Box) node.operand = output();
    if (element->row.kind == ElementClass::Move && maybe())
      node.enable.push_back(this->node(depth + 1));
    for (std::size_t i = 0; i < node.pins.size(); ++i) pin(element->pins[i], node.pins[i], depth);
    return node;
  }
  void pin(const PinRow& row, Pin& pin, int depth) {
    if (row.kind == PinKind::Output || maybe()) return;
    if (row.kind == PinKind::Logic)
      pin.logic.push_back(node(depth + 1));
    else
      pin.operand = value();
  }

  Operand output() { return bit(kOutputs + next_++); }
  Operand value() {
    Operand out = bit(next_++);
    out.kind = OperandKind::Value;
    return out;
  }
  Operand wire() {
    Operand out;
    out.kind = OperandKind::Wire;
    out.number = 5000 + next_++;
    return out;
  }

  const Rules& rules_;
  std::vector<Operand> wires_;
  std::uint32_t next_ = 0;
};

}  // namespace

Operand bit(std::uint32_t number) {
  Operand operand;
  operand.kind = OperandKind::Bit;
  operand.number = number;
  operand.code = operand.text = fmt::format("M {}.{}", number / 8, number % 8);
  return operand;
}

rc::Gen<Network> networks(const Rules& rules) {
  return rc::gen::exec([&rules] { return Maker(rules).network(); });
}

}  // namespace merker::graph::test
