#include "graph/flow.h"

#include "graph/kinds.h"

namespace merker::graph {
namespace {

// Before the bracket closes: there the VKE is that of the group alone.
std::size_t inside(const Node& node) { return node.last - (node.bracketed ? 2 : 1); }

}  // namespace

Selection selectionOf(const Node& node) {
  const bool named = node.bracketed || !isGroup(node);
  return {static_cast<int>(node.last) - 1, kNoPin, named ? -1 : static_cast<int>(node.first)};
}

Selection selectionOf(const Coil& coil) { return {static_cast<int>(coil.last) - 1, kNoPin, -1}; }

void Signals::beginAt(const Flows& before) {
  begin();
  before_ = now_ = before;
}

void Signals::pass(const Node& node) {
  if (inTerm_ && !actsOnSignal(node)) {
    const bool contact = node.kind == NodeKind::Contact;
    const FlowBit bit = !contact ? FlowBit::Vke : node.negated ? FlowBit::NotSta : FlowBit::Sta;
    if (isKnown(now_)) now_.push_back({inside(node), bit});
  } else {
    now_ = before_;
    if (isKnown(now_)) now_.push_back({node.last - 1, FlowBit::Vke});
  }
}

Signals Signals::enter(const Node& group) {
  Signals outer = *this;
  if (group.bracketed || group.kind != NodeKind::Series) {
    before_ = now_;
    inTerm_ = group.kind != NodeKind::Series;
  }
  return outer;
}

void Signals::branch(const Signals& outer) { now_ = outer.now_; }

void Signals::leave(const Node& group, Signals outer) {
  const bool passed = !group.bracketed && group.kind == NodeKind::Series;
  if (passed) {
    outer.now_ = now_;
    *this = std::move(outer);
  } else {
    *this = std::move(outer);
    pass(group);
  }
}

}  // namespace merker::graph
