#include "graph/edit_change.h"

#include <algorithm>

#include "graph/edit_operand.h"
#include "graph/kinds.h"
#include "graph/simplify.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

Node negation() {
  Node node;
  node.kind = NodeKind::Not;
  return node;
}

bool isNot(const Node& node) { return node.kind == NodeKind::Not; }

// What is written behind the NOT of a gate belongs to the gate.
std::size_t behindInputs(const Node& gate) {
  const auto at = std::find_if(gate.children.begin(), gate.children.end(), actsOnSignal);
  return static_cast<std::size_t>(at - gate.children.begin());
}

Refused addInput(const Location& at) {
  Node input = missingContact();
  input.selected = true;
  if (at.list == nullptr) return EditProblem::NoGate;
  if (at.count == 1 && isGroup(at.node())) {
    Node& gate = at.node();
    const std::size_t end =
        gate.kind == NodeKind::Series ? behindInputs(gate) : gate.children.size();
    gate.children.insert(iterator(gate.children, end), std::move(input));
    return std::nullopt;
  }
  if (at.parent == nullptr || !isGroup(*at.parent)) return EditProblem::NoGate;
  at.list->insert(iterator(*at.list, at.end()), std::move(input));
  return std::nullopt;
}

// Turns round what one or several nodes give, not what stands before them.
void negate(const Location& at) {
  std::vector<Node>& list = *at.list;
  Node& node = at.node();
  if (at.count == 1 && node.kind == NodeKind::Contact) {
    node.negated = !node.negated;
  } else if (at.count == 1 && isNot(node)) {
    list[at.from - 1].selected = true;
    list.erase(iterator(list, at.from));
  } else if (at.inSeries() && at.from == 0 && at.end() < list.size() && isNot(list[at.end()])) {
    list.erase(iterator(list, at.end()));
  } else if (at.inSeries() && (at.from == 0 || (at.count == 1 && actsOnSignal(node)))) {
    list.insert(iterator(list, at.end()), negation());
  } else if (at.count == 1 && node.kind == NodeKind::Series && isNot(node.children.back())) {
    node.children.pop_back();
  } else {
    insertBehind({.list = at.list, .from = at.from, .count = at.count}, negation());
  }
}

// All that comes to a coil or a pin.
void negateLogic(std::vector<Node>& logic) {
  if (logic.empty()) logic.push_back(missingContact());
  negate({.list = &logic});
}

Refused negateAt(const Location& at, int pin) {
  if (at.coil != nullptr) {
    if (isRail(*at.coil)) return EditProblem::Rail;
    negateLogic(at.rung->logic);
    return std::nullopt;
  }
  if (pin == kNoPin || pin == kOwn) {
    negate(at);
    return std::nullopt;
  }
  if (at.node().kind != NodeKind::Box) return EditProblem::NoPin;
  std::vector<Node>* logic = logicOfPin(at.node(), pin);
  if (logic == nullptr || logic->empty()) return EditProblem::NotLogic;
  negateLogic(*logic);
  return std::nullopt;
}

// The parallel in one of whose branches the location is: number of its step; and of which.
struct Branch {
  std::size_t step = 0, number = 0;
};
std::optional<Branch> branchAround(const Location& at) {
  for (std::size_t i = at.around.size(); i-- > 0;) {
    const Node& node = at.around[i].node();
    if (!isGroup(node)) break;
    if (node.kind != NodeKind::Parallel) continue;
    return Branch{i, i + 1 < at.around.size() ? at.around[i + 1].at : at.from};
  }
  return std::nullopt;
}

// What a branch cannot go around.
bool endsBranch(const Node& node) { return isBranch(node) || takesSignal(node); }

// a parallel to b, then c: b parallel to a and c.
Refused closeBranch(const Location& at) {
  const auto branch = branchAround(at);
  if (!branch || branch->step == 0) return EditProblem::NoBranch;
  const Step place = at.around[branch->step];
  const Node& outside = at.around[branch->step - 1].node();
  const bool last = place.at + 1 >= place.list->size();
  if (outside.kind != NodeKind::Series || last || endsBranch((*place.list)[place.at + 1]))
    return EditProblem::NoBranch;
  Node parallel = place.node(), series, whole;
  Node mine = std::move(parallel.children[branch->number]);
  parallel.children.erase(iterator(parallel.children, branch->number));
  series.children.push_back(std::move(parallel));
  series.children.push_back(std::move((*place.list)[place.at + 1]));
  whole.kind = NodeKind::Parallel;
  whole.children.push_back(std::move(series));
  whole.children.push_back(std::move(mine));
  place.list->erase(iterator(*place.list, place.at + 1));
  place.node() = std::move(whole);
  return std::nullopt;
}

}  // namespace

std::optional<EditProblem> change(const Location& at, const Edit& edit) {
  if (edit.action == Action::AddInput) return addInput(at);
  (at.coil != nullptr ? at.coil->selected : at.node().selected) = true;
  if (edit.action == Action::Negate) return negateAt(at, edit.at.pin);
  if (edit.action == Action::SetOperand) return setOperand(at, edit);
  return closeBranch(at);
}

}  // namespace merker::graph
