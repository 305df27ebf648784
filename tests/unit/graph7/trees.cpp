#include "trees.h"

#include <fmt/format.h>

#include <algorithm>

#include "graph7/operand_code.h"
#include "graph7/rules.h"

namespace merker::graph7::test {
namespace {

using graph::Join;
using graph::Node;
using graph::NodeKind;

constexpr int kDeepest = 4;

int below(int limit) { return *rc::gen::inRange(0, limit); }

Node contact(Join join) {
  Node node;
  node.kind = NodeKind::Contact;
  node.join = join;
  node.negated = below(2) == 1;
  node.operand = flag(0, static_cast<unsigned>(below(kInputs)));
  return node;
}

Node logic(int depth);

// A contact, or anything else in brackets.
Node part(int depth, Join join) {
  if (depth >= kDeepest || below(2) == 0) return contact(join);
  Node inner = logic(depth + 1);
  inner.bracketed = true;
  inner.join = join;
  return inner;
}

Node series(int depth) {
  Node node;
  node.kind = NodeKind::Series;
  const int count = 2 + below(3);
  for (int i = 0; i < count; ++i) node.children.push_back(part(depth, Join::And));
  if (below(4) == 0) {
    Node negation;
    negation.kind = NodeKind::Not;
    node.children.push_back(negation);
  }
  return node;
}

Node choice(int depth, NodeKind kind) {
  Node node;
  node.kind = kind;
  const Join join = kind == NodeKind::Xor ? Join::Xor : Join::Or;
  const int count = 2 + below(3);
  for (int i = 0; i < count; ++i) node.children.push_back(part(depth, join));
  return node;
}

// AND terms, each of contacts only: they stand behind a bare O.
Node terms() {
  Node node;
  node.kind = NodeKind::Parallel;
  const int count = 2 + below(3);
  for (int i = 0; i < count; ++i) {
    Node term;
    for (int n = 2 + below(2); n > 0; --n) term.children.push_back(contact(Join::And));
    node.children.push_back(term);
  }
  return node;
}

Node logic(int depth) {
  switch (below(4)) {
    case 0:
      return choice(depth, NodeKind::Parallel);
    case 1:
      return choice(depth, NodeKind::Xor);
    case 2:
      return terms();
    default:
      return series(depth);
  }
}

Node unmarked(int depth) {
  const int kind = depth < kDeepest ? below(4) : 0;
  if (kind == 0) return contact(Join::And);
  constexpr NodeKind kKinds[] = {NodeKind::Series, NodeKind::Parallel, NodeKind::Xor};
  Node node;
  node.kind = kKinds[kind - 1];
  for (int count = 1 + below(3); count > 0; --count) node.children.push_back(unmarked(depth + 1));
  if (node.kind == NodeKind::Series && below(3) == 0) {
    Node negation;
    negation.kind = NodeKind::Not;
    node.children.insert(node.children.begin() + 1, negation);
  }
  return node;
}

graph::Network withCoil(Node logic) {
  graph::Network network;
  graph::Rung& rung = network.rungs.emplace_back();
  rung.logic.push_back(std::move(logic));
  rung.coils.push_back({rules().elements->find("COIL"), flag(10, 0), {}, 0, 0});
  return network;
}

bool value(const Node& node, unsigned inputs) {
  const auto isOn = [inputs](const Node& child) { return value(child, inputs); };
  bool signal = true;
  switch (node.kind) {
    case NodeKind::Contact:
      return ((inputs >> (node.operand.number % 8)) & 1u) != (node.negated ? 1u : 0u);
    case NodeKind::Parallel:
      return std::any_of(node.children.begin(), node.children.end(), isOn);
    case NodeKind::Xor:
      return std::count_if(node.children.begin(), node.children.end(), isOn) % 2 == 1;
    case NodeKind::Series:
      for (const Node& child : node.children)
        signal = child.kind == NodeKind::Not ? !signal : (isOn(child) && signal);
      return signal;
    case NodeKind::Not:
    case NodeKind::Edge:
    case NodeKind::OperandEdge:
    case NodeKind::Connector:
    case NodeKind::Box:
      break;
  }
  return false;
}

}  // namespace

graph::Operand flag(unsigned byte, unsigned bit) {
  graph::Operand operand;
  operand.kind = graph::OperandKind::Bit;
  operand.number = bitAddress(byte, bit);
  operand.code = pack({}, mc7::memory(Area::Flag, Width::Bit, operand.number));
  operand.text = fmt::format("M {}.{}", byte, bit);
  return operand;
}

rc::Gen<graph::Network> networks() {
  return rc::gen::exec([] { return withCoil(logic(0)); });
}

rc::Gen<graph::Network> unmarkedNetworks() {
  return rc::gen::exec([] { return withCoil(unmarked(0)); });
}

bool evaluate(const graph::Network& network, unsigned inputs) {
  return value(network.rungs.front().logic.front(), inputs);
}

}  // namespace merker::graph7::test
