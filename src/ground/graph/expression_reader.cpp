#include "graph/expression_reader.h"

#include <utility>

#include "graph/bit_operation.h"
#include "graph/bld.h"
#include "graph/box_reader.h"
#include "graph/kinds.h"
#include "graph/missing.h"

namespace merker::graph {
namespace {

bool isContact(const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::Bit:
    case OperandKind::Wire:
    case OperandKind::Number:
    case OperandKind::Status:
      return true;
    case OperandKind::None:
    case OperandKind::Value:
    case OperandKind::Label:
    case OperandKind::Count:
    case OperandKind::Forbidden:
      break;
  }
  return false;
}

// Trees within trees and boxes behind boxes, besides brackets: more than anybody draws.
constexpr int kMostNested = 100;

// A bracket around what has one already, or around a single contact, is a series of one.
Node inBracket(Node inner, Join join) {
  if (inner.bracketed || !(isGroup(inner) || inner.kind == NodeKind::Box)) {
    Node series;
    series.first = inner.first;
    series.children.push_back(std::move(inner));
    inner = std::move(series);
  }
  inner.bracketed = true;
  inner.join = join;
  return inner;
}

}  // namespace

std::optional<ExpressionReader::Logic> ExpressionReader::read(bool boxes) {
  std::vector<Pin> outer;
  std::swap(outer, parameters_);
  const int outerChain = std::exchange(chained_, 0);
  Signal signal;
  Logic logic;
  bool refused = false;
  while (!cursor_.atEnd() && !logic.ended) {
    if (cursor_.exhausted() || signal.nesting() + chained_ > kMostNested)
      refused = !cursor_.refuse(Reason::Size);
    if (refused) break;
    const std::size_t at = cursor_.at();
    refused = !item(signal);
    if (refused || cursor_.at() != at) continue;
    const bool compareOnly = !boxes;
    if (compareOnly && !signal.empty()) break;
    if (!box(logic, signal, compareOnly)) break;
  }
  if (!parameters_.empty() && !refused) refused = !cursor_.refuse(Reason::Parameter);
  std::swap(outer, parameters_);
  chained_ = outerChain;
  if (refused) return std::nullopt;
  if (logic.ended || signal.empty()) return logic;
  logic.node = signal.take();
  if (!logic.node) {
    cursor_.refuse(Reason::Bare);
    return std::nullopt;
  }
  return logic;
}

// Takes one item of logic if there is one. False: refused.
bool ExpressionReader::item(Signal& signal) {
  if (const BitOperation* row = bitOperation(cursor_.op()))
    return row->bracket ? bracket(signal, *row) : contact(signal, *row);
  if (cursor_.is(Op::AND_BEFORE_OR)) {
    if (!signal.beginTerm()) return cursor_.refuse(Reason::Bare);
    cursor_.take();
    return true;
  }
  if (cursor_.is(Op::NOT) || cursor_.is(Op::EDGE_POSITIVE) || cursor_.is(Op::EDGE_NEGATIVE))
    return acts(signal);
  if (beginsParameter()) return parameter(signal);
  if (beginsConnector()) return connector(signal);
  return true;
}

bool ExpressionReader::contact(Signal& signal, const BitOperation& row) {
  if (signal.empty() && row.op == Op::AND && cursor_.isBld(bld::kOperandEdge, 1))
    return operandEdge(signal);
  if (!isContact(cursor_.look().operand)) return cursor_.refuse(Reason::Operand);
  Node node;
  node.kind = NodeKind::Contact;
  node.join = row.join;
  node.negated = row.negated;
  node.first = cursor_.at();
  node.operand = cursor_.take().operand;
  node.last = cursor_.at();
  return signal.join(std::move(node)) || cursor_.refuse(Reason::Bare);
}

bool ExpressionReader::bracket(Signal& signal, const BitOperation& row) {
  if (depth_ == rules_.deepestBrackets) return cursor_.refuse(Reason::Brackets);
  const std::size_t begin = cursor_.at();
  cursor_.take();
  ++depth_;
  auto inner = read(true);
  --depth_;
  if (!inner) return false;
  if (inner->ended) return cursor_.refuse(Reason::AfterBox);
  if (!inner->node || !cursor_.is(Op::CLOSE)) return cursor_.refuse(Reason::Box);
  cursor_.take();
  Node node = inBracket(std::move(*inner->node), row.join);
  node.first = begin;
  node.last = cursor_.at();
  return signal.join(std::move(node)) || cursor_.refuse(Reason::Bare);
}

// U op; BLD 100; FP m
bool ExpressionReader::operandEdge(Signal& signal) {
  const bool falling = cursor_.is(Op::EDGE_NEGATIVE, 2);
  if (!falling && !cursor_.is(Op::EDGE_POSITIVE, 2)) return cursor_.refuse(Reason::Box);
  Node node;
  node.kind = NodeKind::OperandEdge;
  node.falling = falling;
  node.first = cursor_.at();
  node.operand = cursor_.take().operand;
  cursor_.take();
  node.memory = cursor_.take().operand;
  node.last = cursor_.at();
  if (!isContact(node.operand) || !isContact(node.memory)) {
    cursor_.back(node.first);
    return cursor_.refuse(Reason::Operand);
  }
  return signal.join(std::move(node));
}

// NOT, FP, FN: on the signal so far.
bool ExpressionReader::acts(Signal& signal) {
  Node node;
  node.kind = cursor_.is(Op::NOT) ? NodeKind::Not : NodeKind::Edge;
  node.falling = cursor_.is(Op::EDGE_NEGATIVE);
  if (node.kind == NodeKind::Edge && !isContact(cursor_.look().operand))
    return cursor_.refuse(Reason::Operand);
  if (signal.empty()) return cursor_.refuse(Reason::NoLogic);
  node.first = cursor_.at();
  node.memory = cursor_.take().operand;
  node.last = cursor_.at();
  return signal.append(std::move(node)) || cursor_.refuse(Reason::Bare);
}

bool ExpressionReader::beginsConnector() const {
  return cursor_.is(Op::ASSIGN) && cursor_.is(Op::AND, 1) && isContact(cursor_.look().operand) &&
         cursor_.look().operand == cursor_.look(1).operand &&
         cursor_.look().operand.text != kMissingBit;
}

bool ExpressionReader::connector(Signal& signal) {
  if (signal.empty()) return cursor_.refuse(Reason::NoLogic);
  Node node;
  node.kind = NodeKind::Connector;
  node.first = cursor_.at();
  node.operand = cursor_.take().operand;
  cursor_.take();
  node.last = cursor_.at();
  return signal.append(std::move(node)) || cursor_.refuse(Reason::Bare);
}

bool ExpressionReader::beginsParameter() const {
  return cursor_.is(Op::ASSIGN) && cursor_.look().operand.kind == OperandKind::Wire &&
         cursor_.isBld(bld::kParameter, 1);
}

// Logic of a BOOL parameter: = L 20.0; BLD 103.
bool ExpressionReader::parameter(Signal& signal) {
  std::optional<Node> node = signal.take();
  if (!node) return cursor_.refuse(Reason::NoLogic);
  Pin& pin = parameters_.emplace_back();
  pin.operand = cursor_.take().operand;
  pin.logic.push_back(std::move(*node));
  cursor_.take();
  return true;
}

// The first element that fits takes what stands before it. False: none does.
bool ExpressionReader::box(Logic& logic, Signal& signal, bool compareOnly) {
  for (const Element& element : rules_.elements->elements()) {
    const ElementClass kind = element.row.kind;
    if (kind == ElementClass::Coil || kind == ElementClass::RailCoil) continue;
    if (kind == ElementClass::Compare ? !signal.empty() : compareOnly) continue;
    if (!BoxReader::couldBegin(element, cursor_)) continue;
    Signal kept = signal;
    std::optional<Node> before = signal.empty() ? std::nullopt : signal.take();
    Node node;
    if (BoxReader(cursor_, *this, rules_).read(element, before, parameters_, node)) {
      ++chained_;
      logic.ended = !node.continues;
      if (!logic.ended) return signal.join(std::move(node));
      logic.node = std::move(node);
      return true;
    }
    signal = std::move(kept);
  }
  return false;
}

}  // namespace merker::graph
