#include "graph/locate.h"

#include <iterator>

#include "graph/kinds.h"

namespace merker::graph {
namespace {

using Found = std::optional<Location>;

class Finder {
 public:
  Finder(Rung& rung, const Selection& selection)
      : rung_(rung), last_(static_cast<std::size_t>(selection.node) + 1), first_(selection.first) {}

  Found find() {
    for (Coil& coil : rung_.coils)
      if (first_ < 0 && coil.last == last_) return Location{.rung = &rung_, .coil = &coil};
    return find(rung_.logic, nullptr);
  }

 private:
  Found find(std::vector<Node>& list, Node* parent) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (isMeant(list[i])) return at(list, i, 1, parent);
    if (parent != nullptr && parent->kind == NodeKind::Series &&
        list.data() == parent->children.data())
      if (Found some = findSome(list, parent)) return some;
    for (std::size_t i = 0; i < list.size(); ++i) {
      around_.push_back({&list, i});
      if (Found found = findBelow(list[i])) return found;
      around_.pop_back();
    }
    return std::nullopt;
  }

  // A gate of FUP has those of a series that stand before the next NOT, edge or connector.
  Found findSome(std::vector<Node>& list, Node* parent) {
    std::size_t from = list.size();
    for (std::size_t i = 0; i < list.size() && first_ >= 0; ++i) {
      if (list[i].first == static_cast<std::size_t>(first_)) from = i;
      if (from <= i && list[i].last == last_) return at(list, from, i - from + 1, parent);
    }
    return std::nullopt;
  }

  Found findBelow(Node& node) {
    if (Found found = find(node.children, &node)) return found;
    if (Found found = find(node.enable, &node)) return found;
    for (std::vector<Pin>* pins : {&node.pins, &node.parameters})
      for (Pin& pin : *pins)
        if (Found found = find(pin.logic, &node)) return found;
    return std::nullopt;
  }

  bool isMeant(const Node& node) const {
    if (node.last != last_) return false;
    if (first_ >= 0) return node.first == static_cast<std::size_t>(first_);
    return !isUnbracketedGroup(node);
  }
  Location at(std::vector<Node>& list, std::size_t from, std::size_t count, Node* parent) {
    return {&rung_, nullptr, &list, from, count, parent, around_};
  }

  Rung& rung_;
  std::size_t last_;
  int first_;
  std::vector<Step> around_;
};

}  // namespace

std::vector<Node>::iterator iterator(std::vector<Node>& list, std::size_t at) {
  return list.begin() + static_cast<std::ptrdiff_t>(at);
}

std::optional<Location> locate(Network& network, const Selection& selection) {
  if (selection.node < 0) return std::nullopt;
  for (Rung& rung : network.rungs)
    if (Found found = Finder(rung, selection).find()) return found;
  return std::nullopt;
}

Location wholeLogic(Rung& rung) { return {.rung = &rung, .list = &rung.logic}; }

bool isTrunk(Rung& rung, const std::vector<Node>* list) {
  std::vector<Node>* trunk = &rung.logic;
  while (trunk != list) {
    if (trunk->empty()) return false;
    Node& first = trunk->front();
    if (first.kind == NodeKind::Series)
      trunk = &first.children;
    else if (!first.enable.empty())
      trunk = &first.enable;
    else if (!first.pins.empty())
      trunk = &first.pins.front().logic;
    else
      return false;
  }
  return true;
}

Node takeOut(const Location& at) {
  Node out;
  if (at.count == 1) {
    out = std::move(at.node());
  } else {
    const auto from = std::make_move_iterator(iterator(*at.list, at.from));
    out.children.assign(from, from + static_cast<std::ptrdiff_t>(at.count));
  }
  at.list->erase(iterator(*at.list, at.from), iterator(*at.list, at.end()));
  return out;
}

void insertBehind(const Location& at, Node node) {
  std::vector<Node> nodes;
  if (node.kind == NodeKind::Series && !node.bracketed) {
    if (node.selected) node.children.back().selected = true;
    nodes = std::move(node.children);
  } else {
    nodes.push_back(std::move(node));
  }
  const auto first = std::make_move_iterator(nodes.begin()),
             last = std::make_move_iterator(nodes.end());
  if (at.inSeries()) {
    at.list->insert(iterator(*at.list, at.end()), first, last);
    return;
  }
  Node series;
  series.children.push_back(takeOut(at));
  series.children.insert(series.children.end(), first, last);
  at.list->insert(iterator(*at.list, at.from), std::move(series));
}

}  // namespace merker::graph
