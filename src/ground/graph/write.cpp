#include "graph/write.h"

#include "graph/bit_operation.h"
#include "graph/bld.h"
#include "graph/kinds.h"

namespace merker::graph {
namespace {

// How the first statement of the node joins what stands before it.
Join firstJoin(const Node& node) {
  return isUnbracketedGroup(node) && !node.children.empty() ? firstJoin(node.children.front())
                                                            : node.join;
}

class Writer {
 public:
  explicit Writer(const Rules& rules) : rules_(rules) {}

  Statements write(Network& network) {
    for (Rung& rung : network.rungs) this->rung(rung);
    return std::move(out_);
  }

 private:
  void add(Op op, const Operand& operand = {}) {
    Statement& statement = out_.emplace_back();
    statement.op = op;
    statement.operand = operand;
  }
  void addBld(std::uint32_t number) {
    Operand operand;
    operand.kind = OperandKind::Count;
    operand.number = number;
    add(Op::BLD, operand);
  }

  void rung(Rung& rung) {
    if (!rung.logic.empty()) node(rung.logic.front());
    if (rung.straight) addBld(bld::kStraight);
    for (Coil& coil : rung.coils) this->coil(coil);
  }

  void coil(Coil& coil) {
    coil.first = out_.size();
    for (const Item& item : coil.element->items) {
      if (item.kind == ItemKind::Own)
        add(item.op, coil.operand);
      else if (item.kind == ItemKind::Value)
        add(item.op, coil.values[item.pin]);
      else
        add(item.op);
    }
    coil.last = out_.size();
  }

  void node(Node& node) {
    node.first = out_.size();
    if (node.bracketed) add(operationFor(node.join, false, true));
    inside(node);
    if (node.bracketed) add(Op::CLOSE);
    node.last = out_.size();
  }

  void inside(Node& node) {
    switch (node.kind) {
      case NodeKind::Series:
      case NodeKind::Xor:
        for (Node& child : node.children) this->node(child);
        break;
      case NodeKind::Parallel:
        parallel(node);
        break;
      case NodeKind::Contact:
        add(operationFor(node.join, node.negated, false), node.operand);
        break;
      case NodeKind::Not:
        add(Op::NOT);
        break;
      case NodeKind::Edge:
        add(node.falling ? Op::EDGE_NEGATIVE : Op::EDGE_POSITIVE, node.memory);
        break;
      case NodeKind::OperandEdge:
        add(Op::AND, node.operand);
        addBld(bld::kOperandEdge);
        add(node.falling ? Op::EDGE_NEGATIVE : Op::EDGE_POSITIVE, node.memory);
        break;
      case NodeKind::Connector:
        add(Op::ASSIGN, node.operand);
        add(Op::AND, node.operand);
        break;
      case NodeKind::Box:
        box(node);
        break;
    }
  }

  // The bare O stands before an AND term.
  void parallel(Node& node) {
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      if (i > 0 && firstJoin(node.children[i]) == Join::And) add(Op::AND_BEFORE_OR);
      this->node(node.children[i]);
    }
  }

  void box(Node& node) {
    const ElementClass kind = node.element->row.kind;
    if (kind != ElementClass::Move && kind != ElementClass::Call) return items(node);
    for (Pin& parameter : node.parameters) {
      this->node(parameter.logic.front());
      add(Op::ASSIGN, parameter.operand);
      addBld(bld::kParameter);
    }
    const std::size_t jump = enable(node);
    if (kind == ElementClass::Call) {
      add(Op::CALL, node.operand);
      out_.back().arguments = node.arguments;
    } else {
      items(node);
    }
    eno(node.eno);
    if (!node.enable.empty()) out_[jump].target = static_cast<std::int32_t>(out_.size());
    node.continues ? add(Op::AND, rules_.binaryResult) : add(Op::NOP0);
  }

  // Returns the number of the jump.
  std::size_t enable(Node& node) {
    if (node.enable.empty()) return 0;
    this->node(node.enable.front());
    Operand label;
    label.kind = OperandKind::Label;
    add(Op::SPBNB, label);
    return out_.size() - 1;
  }

  void eno(Eno how) {
    if (how == Eno::None) return;
    how == Eno::Overflow ? add(Op::AND_NOT, rules_.overflow) : add(Op::SET);
    add(Op::SAVE);
    add(Op::CLR);
  }

  void items(Node& node) {
    const std::vector<Item>& items = node.element->items;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (items[i].kind != ItemKind::Begin) {
        item(node, items[i]);
        continue;
      }
      const Item& end = items[i + items[i].number];
      if (!isOpen(node, i)) continue;
      for (std::uint32_t n = 0; n < end.number; ++n) add(Op::NOP0);
      i += items[i].number;
    }
  }

  // Whether the group that begins there is left out: its pins are open.
  static bool isOpen(const Node& node, std::size_t begin) {
    const std::vector<Item>& items = node.element->items;
    for (std::size_t i = begin + 1; i < begin + items[begin].number; ++i)
      if (items[i].kind == ItemKind::Logic || items[i].kind == ItemKind::Value)
        return node.pins[items[i].pin].open;
    return false;
  }

  void item(Node& node, const Item& item) {
    switch (item.kind) {
      case ItemKind::Logic:
        this->node(node.pins[item.pin].logic.front());
        break;
      case ItemKind::Own:
        add(item.op, node.operand);
        break;
      case ItemKind::Value:
        add(item.op, node.pins[item.pin].operand);
        break;
      case ItemKind::Plain:
        add(item.op);
        break;
      case ItemKind::Bld:
        addBld(item.number);
        break;
      case ItemKind::Output:
        node.continues ? add(Op::AND, node.operand) : add(Op::NOP0);
        break;
      case ItemKind::Begin:
      case ItemKind::End:
        break;
    }
  }

  const Rules& rules_;
  Statements out_;
};

}  // namespace

Statements write(const Network& network, const Rules& rules) {
  Network copy = network;
  return Writer(rules).write(copy);
}

Statements writeNumbered(Network& network, const Rules& rules) {
  return Writer(rules).write(network);
}

}  // namespace merker::graph
