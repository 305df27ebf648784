#include "graph/simplify.h"

#include <algorithm>
#include <iterator>

#include "graph/kinds.h"
#include "graph/missing.h"

namespace merker::graph {
namespace {

bool actsInside(const Node& series) {
  return std::any_of(series.children.begin(), series.children.end(), actsOnSignal);
}

bool dissolves(const Node& child, const Node& group, bool first) {
  if (child.kind != group.kind) return false;
  return child.kind == NodeKind::Parallel ||
         (child.kind == NodeKind::Series && (first || !actsInside(child)));
}

bool simplify(Node& node);

void simplifyPins(Node& box) {
  simplify(box.enable);
  for (Pin& pin : box.pins) simplify(pin.logic);
  for (Pin& pin : box.parameters) simplify(pin.logic);
}

// False: nothing is left of it.
bool simplify(Node& node) {
  simplifyPins(node);
  if (!isGroup(node)) return true;
  std::vector<Node> children;
  for (Node& child : node.children) {
    if (!simplify(child)) continue;
    if (!dissolves(child, node, children.empty())) {
      children.push_back(std::move(child));
      continue;
    }
    if (child.selected) child.children.back().selected = true;
    std::move(child.children.begin(), child.children.end(), std::back_inserter(children));
  }
  if (children.empty()) return false;
  if (actsOnSignal(children.front())) children.insert(children.begin(), missingContact());
  if (children.size() == 1) {
    Node only = std::move(children.front());
    only.selected = only.selected || node.selected;
    node = std::move(only);
  } else {
    node.children = std::move(children);
  }
  return true;
}

}  // namespace

Node missingContact() {
  Node node;
  node.kind = NodeKind::Contact;
  node.operand = missing(kMissingBit);
  return node;
}

void simplify(std::vector<Node>& logic) {
  if (logic.empty()) return;
  if (!simplify(logic.front())) return logic.clear();
  if (!actsOnSignal(logic.front())) return;
  Node series;
  series.children = {missingContact(), std::move(logic.front())};
  logic.front() = std::move(series);
}

}  // namespace merker::graph
