#include "graph/edit_place.h"

#include <algorithm>

#include "graph/kinds.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

bool isInParallel(const Location& at) {
  return std::any_of(at.around.begin(), at.around.end(),
                     [](const Step& step) { return step.node().kind == NodeKind::Parallel; });
}

// Before the first element of a rung: at the rail, also where branches begin there.
Location fromRail(const Location& at) {
  const bool first =
      at.from == 0 && std::all_of(at.around.begin(), at.around.end(), [](const Step& step) {
        return isGroup(step.node()) && step.at == 0;
      });
  return first && !at.rung->logic.empty() && isInParallel(at) ? wholeLogic(*at.rung) : at;
}

bool isChain(const Node& node) { return node.kind == NodeKind::Series && !node.bracketed; }

const Node& leadingNode(const Node& node) {
  return isChain(node) && !node.children.empty() ? leadingNode(node.children.front()) : node;
}

// The node, to which the signal comes.
Refused lead(Node& node, Node signal) {
  if (isChain(node) && takesSignal(leadingNode(node)))
    return lead(node.children.front(), std::move(signal));
  if (!takesSignal(node)) {
    node = gate(NodeKind::Series, std::move(signal), std::move(node));
    return std::nullopt;
  }
  std::vector<Node>* pin = signalInto(node);
  if (pin == nullptr) return EditProblem::BoxPlace;
  if (!pin->empty()) return lead(pin->front(), std::move(signal));
  pin->push_back(std::move(signal));
  return std::nullopt;
}

}  // namespace

bool beginsOnSignal(const Node& node) { return actsOnSignal(leadingNode(node)); }

std::vector<Node>* signalInto(Node& node) {
  if (!takesSignal(node)) return nullptr;
  const ElementClass kind = node.element->row.kind;
  if (kind == ElementClass::Move || kind == ElementClass::Call) return &node.enable;
  for (std::size_t i = 0; i < node.pins.size(); ++i)
    if (node.element->pins[i].kind == PinKind::Logic) return &node.pins[i].logic;
  return nullptr;
}

Node gate(NodeKind kind, Node first, Node second) {
  Node group;
  group.kind = kind;
  group.children.push_back(std::move(first));
  group.children.push_back(std::move(second));
  return group;
}

void put(const Location& at, Node node) {
  at.list->insert(at.list->begin() + static_cast<std::ptrdiff_t>(at.from), std::move(node));
}

Refused behind(const Location& at, Node node) {
  if (!takesSignal(leadingNode(node))) {
    insertBehind(at, std::move(node));
    return std::nullopt;
  }
  Location all = at;
  if (at.inSeries()) {
    all.from = 0;
    all.count = at.end();
  }
  if (const Refused refused = lead(node, takeOut(all))) return refused;
  put(all, std::move(node));
  return std::nullopt;
}

Refused before(const Location& place, Node node) {
  const Location at = fromRail(place);
  if (at.count == 1 && takesSignal(at.node()) && !takesSignal(leadingNode(node))) {
    std::vector<Node>* pin = signalInto(at.node());
    if (pin == nullptr) return EditProblem::BoxPlace;
    if (!pin->empty())
      return behind({.rung = at.rung, .list = pin, .parent = &at.node()}, std::move(node));
    if (beginsOnSignal(node)) return EditProblem::Rail;
    pin->push_back(std::move(node));
    return std::nullopt;
  }
  if (at.inSeries() && at.from > 0) {
    Location left = at;
    left.from = at.from - 1;
    left.count = 1;
    return behind(left, std::move(node));
  }
  if (beginsOnSignal(node) || (at.count == 1 && actsOnSignal(at.node()))) return EditProblem::Rail;
  Node series = gate(NodeKind::Series, std::move(node), takeOut(at));
  put(at, std::move(series));
  return std::nullopt;
}

}  // namespace merker::graph
