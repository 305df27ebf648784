#include "graph/complete.h"

#include <algorithm>

#include "graph/kinds.h"
#include "graph/missing.h"
#include "graph/simplify.h"

namespace merker::graph {
namespace {

bool isGiven(const Operand& operand) { return operand.kind != OperandKind::None; }

void give(Operand& operand, std::string_view text) {
  if (!isGiven(operand)) operand = missing(text);
}

// A flag or output, or what has a number: a timer, a counter, a block, a label.
std::string_view missingOwn(const Element& element) {
  const auto isBit = [](const Item& item) {
    return item.kind != ItemKind::Own || item.op == Op::ASSIGN || item.op == Op::SET_BIT ||
           item.op == Op::RESET_BIT;
  };
  const bool values = std::any_of(element.items.begin(), element.items.end(),
                                  [](const Item& item) { return item.kind == ItemKind::Value; });
  return !values && std::all_of(element.items.begin(), element.items.end(), isBit) ? kMissingBit
                                                                                   : kMissingValue;
}

bool hasOwn(const Element& element) {
  return std::any_of(element.items.begin(), element.items.end(),
                     [](const Item& item) { return item.kind == ItemKind::Own; });
}

class BoxCompleter {
 public:
  explicit BoxCompleter(Node& box) : box_(box), items_(box.element->items) {}

  void complete() {
    box_.pins.resize(box_.element->pins.size());
    if (hasOwn(*box_.element)) give(box_.operand, missingOwn(*box_.element));
    if (box_.element->row.kind == ElementClass::Call) give(box_.operand, kMissingValue);
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const bool group = items_[i].kind == ItemKind::Begin;
      const std::size_t end = group ? i + items_[i].number : i + 1;
      const bool used = !group || isUsed(i, end) || (i == 0 && tellsApart());
      for (; i < end; ++i) pin(items_[i], used);
      if (!group) --i;
    }
  }

 private:
  static bool hasPin(const Item& item) {
    return item.kind == ItemKind::Logic || item.kind == ItemKind::Value;
  }
  bool isUsed(std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (!hasPin(items_[i])) continue;
      const Pin& pin = box_.pins[items_[i].pin];
      if (!pin.logic.empty() || isGiven(pin.operand)) return true;
    }
    return false;
  }
  // Without their count input counters of one input look the same, and without any pin nothing says
  // which counter is meant.
  bool tellsApart() const {
    const bool marked = std::any_of(items_.begin(), items_.end(),
                                    [](const Item& item) { return item.kind == ItemKind::Bld; });
    return marked || !isUsed(0, items_.size());
  }
  void pin(const Item& item, bool used) {
    if (!hasPin(item)) return;
    Pin& pin = box_.pins[item.pin];
    pin.open = !used;
    if (!used) return;
    if (item.kind == ItemKind::Value) give(pin.operand, kMissingValue);
    if (item.kind == ItemKind::Logic && pin.logic.empty()) pin.logic.push_back(missingContact());
  }

  Node& box_;
  const std::vector<Item>& items_;
};

void complete(std::vector<Node>& nodes) {
  for (Node& node : nodes) merker::graph::complete(node);
}

void complete(std::vector<Pin>& pins) {
  for (Pin& pin : pins) complete(pin.logic);
}

}  // namespace

void complete(Node& node) {
  if (node.kind == NodeKind::Contact || node.kind == NodeKind::OperandEdge)
    give(node.operand, kMissingBit);
  if (node.kind == NodeKind::Edge || node.kind == NodeKind::OperandEdge)
    give(node.memory, kMissingBit);
  if (node.kind == NodeKind::Connector) {
    give(node.operand, kMissingConnector);
    if (node.operand.text == kMissingBit) node.operand = missing(kMissingConnector);
  }
  if (node.kind == NodeKind::Box) BoxCompleter(node).complete();
  dropEmptyParameters(node);
  complete(node.children);
  complete(node.enable);
  complete(node.pins);
  complete(node.parameters);
}

void dropEmptyParameters(Node& call) {
  std::erase_if(call.parameters, [&call](const Pin& parameter) {
    if (!parameter.logic.empty()) return false;
    for (Argument& argument : call.arguments)
      if (argument.wire == parameter.operand.number) {
        argument.wire = -1;
        argument.text.clear();
      }
    return true;
  });
}

void complete(Coil& coil) {
  if (hasOwn(*coil.element)) give(coil.operand, missingOwn(*coil.element));
  coil.values.resize(coil.element->pins.size());
  for (Operand& value : coil.values) give(value, kMissingValue);
}

void complete(Network& network, const Rules& rules, Unfinished unfinished) {
  std::erase_if(network.rungs,
                [](const Rung& rung) { return rung.logic.empty() && rung.coils.empty(); });
  for (Rung& rung : network.rungs) {
    const bool last = &rung == &network.rungs.back();
    const bool alone = unfinished == Unfinished::Part && &rung == &network.rungs.front();
    if (rung.logic.empty() && rung.coils.size() == 1)
      rung.coils.front().element = &rules.elements->counterpart(*rung.coils.front().element, false);
    if (rung.logic.empty() && !alone && !isRail(rung.coils.front()))
      rung.logic.push_back(missingContact());
    if (rung.coils.empty() && !last && !takesSignal(rung.logic.front()))
      rung.coils.push_back({rules.elements->find("COIL"), {}, {}, 0, 0});
    complete(rung.logic);
    for (Coil& coil : rung.coils) {
      if (!rung.logic.empty()) coil.element = &rules.elements->counterpart(*coil.element, true);
      complete(coil);
    }
  }
}

}  // namespace merker::graph
