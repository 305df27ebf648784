#include "graph/wire_numbers.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "graph/kinds.h"
#include "graph/wires.h"

namespace merker::graph {
namespace {

class Numberer {
 public:
  Numberer(Network& network, std::uint32_t first) : network_(network), next_(first) {
    findForeign();
  }

  void number() {
    for (Rung& rung : network_.rungs) {
      rung.straight =
          !rung.logic.empty() && beginsPlain(rung.coils) && endsInBranch(rung.logic.front());
      for (Node& node : rung.logic) this->node(node);
    }
  }

 private:
  // Bits that coils write, or nobody: the author uses them on his own.
  void findForeign() {
    std::vector<std::uint32_t> written;
    for (const Rung& rung : network_.rungs) {
      for (const Node& node : rung.logic) collectWires(node, written);
      for (const Coil& coil : rung.coils)
        if (isWire(coil.operand)) assigned_.insert(coil.operand.number);
    }
    foreign_ = assigned_;
    const std::set<std::uint32_t> own(written.begin(), written.end());
    for (const Rung& rung : network_.rungs)
      for (const Node& node : rung.logic)
        visit(node, [this, &own](const Node& below) {
          if (isWire(below.operand) && !own.contains(below.operand.number))
            foreign_.insert(below.operand.number);
        });
  }

  // Before a timer its time is loaded.
  static bool beginsPlain(const std::vector<Coil>& coils) {
    return !coils.empty() && coils.front().element->items.front().kind == ItemKind::Own;
  }

  // Nothing stands between the branch and the coils.
  bool endsInBranch(const Node& logic) const {
    const Node& last = logic.kind == NodeKind::Series ? logic.children.back() : logic;
    if (!isWire(last.operand)) return false;
    if (last.kind == NodeKind::Connector) return true;
    return &last == &logic && last.kind == NodeKind::Contact && !last.negated &&
           (numbers_.contains(last.operand.number) || assigned_.contains(last.operand.number));
  }

  // In the order of the statements.
  void node(Node& node) {
    for (Node& child : node.children) this->node(child);
    for (Pin& pin : node.pins)
      for (Node& child : pin.logic) this->node(child);
    for (Pin& parameter : node.parameters) this->parameter(node, parameter);
    for (Node& child : node.enable) this->node(child);
    if (node.kind == NodeKind::Connector && isWire(node.operand)) write(node.operand);
    if (node.kind == NodeKind::Contact && isWire(node.operand)) read(node.operand);
  }

  void parameter(Node& call, Pin& parameter) {
    for (Node& child : parameter.logic) node(child);
    const std::uint32_t old = parameter.operand.number;
    write(parameter.operand);
    for (Argument& argument : call.arguments)
      if (argument.wire == old && !done_.contains(&argument)) {
        argument.wire = parameter.operand.number;
        argument.text = parameter.operand.text;
        done_.insert(&argument);
        break;
      }
  }

  void write(Operand& operand) {
    while (foreign_.contains(next_)) ++next_;
    numbers_[operand.number] = next_;
    operand = wireOperand(next_++);
  }
  void read(Operand& operand) const {
    const auto at = numbers_.find(operand.number);
    if (at != numbers_.end()) operand = wireOperand(at->second);
  }

  Network& network_;
  std::uint32_t next_;
  std::map<std::uint32_t, std::uint32_t> numbers_;  // by the number it had
  std::set<std::uint32_t> foreign_, assigned_;      // `assigned_`: by coils, which are foreign, too
  std::set<const Argument*> done_;
};

}  // namespace

Operand wireOperand(std::uint32_t number) {
  Operand operand;
  operand.kind = OperandKind::Wire;
  operand.number = number;
  operand.text = fmt::format("L {}.{}", number / 8, number % 8);
  return operand;
}

void numberWires(Network& network, std::uint32_t first) { Numberer(network, first).number(); }

}  // namespace merker::graph
