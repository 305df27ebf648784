#include "graph/canonical.h"

#include <algorithm>

#include "graph/complete.h"
#include "graph/kinds.h"
#include "graph/simplify.h"
#include "graph/wire_numbers.h"

namespace merker::graph {
namespace {

// Sets how nodes join each other, what stands in brackets and what goes on behind its output. Only
// contacts, and what acts on the signal, stand without brackets in a series and at a pin.
class Marker {
 public:
  void rung(Rung& rung) {
    if (rung.logic.empty()) return;
    Node& logic = rung.logic.front();
    if (branchesAtOnce(logic))
      series(logic, true);
    else
      inside(logic, !rung.coils.empty());
  }

 private:
  // What stands alone in a rung or in brackets. `follows`: its signal goes somewhere.
  void inside(Node& node, bool follows) {
    node.bracketed = false;
    node.join = Join::And;
    switch (node.kind) {
      case NodeKind::Series:
        return series(node);
      case NodeKind::Parallel:
        return parallel(node);
      case NodeKind::Xor:
        for (Node& child : node.children) joined(child, Join::Xor);
        return;
      case NodeKind::Box:
        return box(node, follows);
      case NodeKind::Contact:
      case NodeKind::Not:
      case NodeKind::Edge:
      case NodeKind::OperandEdge:
      case NodeKind::Connector:
        return;
    }
  }

  // To the first branch of a rung goes what would go to its coil.
  static bool branchesAtOnce(const Node& node) {
    return node.kind == NodeKind::Series && isBranch(node.children[1]);
  }

  void series(Node& node, bool firstAlone = false) {
    node.bracketed = false;
    node.join = Join::And;
    for (Node& child : node.children)
      if (firstAlone && &child == &node.children.front())
        inside(child, true);
      else
        joined(child, Join::And);
  }

  // AND terms stand behind a bare O, without brackets.
  void parallel(Node& node) {
    for (Node& child : node.children) {
      if (isTerm(child))
        series(child);
      else
        joined(child, Join::Or);
    }
  }
  static bool isTerm(const Node& node) {
    return node.kind == NodeKind::Series &&
           std::none_of(node.children.begin(), node.children.end(), actsOnSignal);
  }
  // One of several.
  void joined(Node& node, Join join) {
    const bool leaf = node.kind == NodeKind::Contact || actsOnSignal(node);
    if (!leaf) return bracketed(node, join);
    node.bracketed = false;
    node.join = actsOnSignal(node) ? Join::And : join;
  }

  void bracketed(Node& node, Join join) {
    if (node.kind == NodeKind::OperandEdge) {  // alone in its brackets
      Node series;
      series.children.push_back(std::move(node));
      node = std::move(series);
    } else {
      inside(node, true);
    }
    node.bracketed = true;
    node.join = join;
  }

  void box(Node& node, bool follows) {
    node.continues = follows || isCompare(node);
    for (std::size_t i = 0; i < node.pins.size(); ++i)
      if (node.element->pins[i].kind == PinKind::Output) node.pins[i].open = !node.continues;
    const bool works = node.continues && node.element->row.kind == ElementClass::Move;
    if (!works)
      node.eno = Eno::None;
    else if (node.eno == Eno::None)
      node.eno = node.element->row.eno;
    atPin(node.enable);
    for (Pin& pin : node.pins) atPin(pin.logic);
    for (Pin& pin : node.parameters) atPin(pin.logic);
  }
  void atPin(std::vector<Node>& logic) {
    for (Node& node : logic) node.kind == NodeKind::Series ? series(node) : joined(node, Join::And);
  }
};

}  // namespace

Network canonical(Network network, const Rules& rules, std::uint32_t firstWire,
                  Unfinished unfinished) {
  for (Rung& rung : network.rungs) simplify(rung.logic);
  complete(network, rules, unfinished);
  for (Rung& rung : network.rungs) Marker().rung(rung);
  numberWires(network, firstWire);
  return network;
}

}  // namespace merker::graph
