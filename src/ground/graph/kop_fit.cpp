#include <algorithm>

#include "graph/branches.h"
#include "graph/kinds.h"
#include "graph/kop.h"
#include "graph/wires.h"

namespace merker::graph {
namespace {

class Fitter {
 public:
  Fitter(const Network& network, const Rules& rules) : network_(network), rules_(rules) {
    for (const Rung& rung : network.rungs)
      for (const Node& node : rung.logic) collectWires(node, wires_);
  }

  bool fits() const {
    return std::all_of(network_.rungs.begin(), network_.rungs.end(),
                       [this](const Rung& rung) { return all(rung.logic, true); });
  }

 private:
  // `first`: it stands behind the rail or a branch.
  bool all(const std::vector<Node>& nodes, bool first) const {
    return std::all_of(nodes.begin(), nodes.end(),
                       [this, first](const Node& node) { return fits(node, first); });
  }
  bool all(const std::vector<Pin>& pins) const {
    return std::all_of(pins.begin(), pins.end(),
                       [this](const Pin& pin) { return all(pin.logic, true); });
  }

  bool fits(const Node& node, bool first) const {
    switch (node.kind) {
      case NodeKind::Series:
        return series(node, first);
      case NodeKind::Parallel:  // all its branches begin at the same place
        return all(node.children, first) && !anyBeginsAtBranch(node.children) &&
               (rules_.boxBeforeOr || !hasBox(node));
      case NodeKind::Box:
        return box(node, first);
      case NodeKind::Xor:
        return false;
      case NodeKind::Contact:
      case NodeKind::Not:
      case NodeKind::Edge:
      case NodeKind::OperandEdge:
      case NodeKind::Connector:
        break;
    }
    return true;
  }

  // What acts on the signal so far: in ladder that is all from the rail on.
  bool series(const Node& node, bool first) const {
    for (const Node& child : node.children) {
      const bool leads = &child == &node.children.front();
      if (actsOnSignal(child) ? !first : !fits(child, first && leads)) return false;
    }
    return true;
  }

  bool box(const Node& box, bool first) const {
    if (isCompare(box)) return true;
    return first && all(box.enable, true) && all(box.pins) && all(box.parameters);
  }

  static bool hasBox(const Node& node) {
    bool found = false;
    visit(node, [&found](const Node& below) { found = found || below.kind == NodeKind::Box; });
    return found;
  }

  bool anyBeginsAtBranch(const std::vector<Node>& nodes) const {
    return std::any_of(nodes.begin(), nodes.end(), [this](const Node& node) {
      const Node* contact = firstContact(node);
      return contact != nullptr && contact->operand.kind == OperandKind::Wire &&
             std::find(wires_.begin(), wires_.end(), contact->operand.number) != wires_.end();
    });
  }

  const Network& network_;
  const Rules& rules_;
  std::vector<std::uint32_t> wires_;
};

}  // namespace

bool fitsKop(const Network& network, const Rules& rules) { return Fitter(network, rules).fits(); }

}  // namespace merker::graph
