#include "graph/edit_branches.h"

#include <algorithm>
#include <set>

#include "graph/branches.h"
#include "graph/kinds.h"
#include "graph/missing.h"
#include "graph/simplify.h"
#include "graph/wires.h"

namespace merker::graph {
namespace {

using Wires = std::set<std::uint32_t>;

void addWritten(const Rung& rung, Wires& wires) {
  std::vector<std::uint32_t> some;
  for (const Node& node : rung.logic) collectWires(node, some);
  wires.insert(some.begin(), some.end());
}
// Of calls.
Wires givenWires(const Network& network) {
  Wires wires;
  for (const Rung& rung : network.rungs)
    for (const Node& logic : rung.logic)
      visit(logic, [&wires](const Node& node) {
        for (const Pin& parameter : node.parameters) wires.insert(parameter.operand.number);
      });
  return wires;
}
Wires written(const Network& network) {
  Wires wires;
  for (const Rung& rung : network.rungs) {
    addWritten(rung, wires);
    for (const Coil& coil : rung.coils)
      if (isWire(coil.operand)) wires.insert(coil.operand.number);
  }
  return wires;
}
Wires readWires(const Network& network) {
  Wires wires;
  for (const Rung& rung : network.rungs)
    for (const Node& logic : rung.logic)
      visit(logic, [&wires](const Node& node) {
        if (node.kind == NodeKind::Contact && isWire(node.operand))
          wires.insert(node.operand.number);
      });
  return wires;
}

std::optional<std::uint32_t> beginsAt(const Rung& rung) {
  const Node* first = rung.logic.empty() ? nullptr : firstContact(rung.logic.front());
  if (first == nullptr || !isWire(first->operand)) return std::nullopt;
  return first->operand.number;
}

// Wires of an edit; they are counted again afterwards.
constexpr std::uint32_t kBehindAll = 0x4000'0000;

// A number that no wire has yet.
std::uint32_t freshWire(const Network& network) {
  std::uint32_t fresh = kBehindAll;
  for (const Wires& wires : {written(network), readWires(network), givenWires(network)})
    if (!wires.empty()) fresh = std::max(fresh, *wires.rbegin() + 1);
  return fresh;
}

std::size_t behind(const Network& network, std::size_t rung, Wires wires) {
  for (++rung; rung < network.rungs.size(); ++rung) {
    const auto begin = beginsAt(network.rungs[rung]);
    if (!begin || !wires.contains(*begin)) break;
    addWritten(network.rungs[rung], wires);
  }
  return rung;
}

void change(std::vector<Node>& nodes, const std::function<void(std::vector<Node>&)>& what) {
  what(nodes);
  for (Node& node : nodes) {
    change(node.children, what);
    change(node.enable, what);
    for (std::vector<Pin>* pins : {&node.pins, &node.parameters})
      for (Pin& pin : *pins) change(pin.logic, what);
  }
}

void changeNodes(Network& network, const std::function<void(Node&)>& what) {
  for (Rung& rung : network.rungs)
    change(rung.logic,
           [&what](std::vector<Node>& nodes) { std::for_each(nodes.begin(), nodes.end(), what); });
}

// Contacts that read what nobody writes any more.
void dropReads(Network& network, const Wires& lost) {
  for (Rung& rung : network.rungs)
    change(rung.logic, [&lost](std::vector<Node>& nodes) {
      for (Node& node : nodes)
        if (node.kind == NodeKind::Contact && isWire(node.operand) &&
            lost.contains(node.operand.number))
          node.operand = missing(kMissingBit);
    });
}

Wires difference(const Wires& from, const Wires& what) {
  Wires out;
  std::set_difference(from.begin(), from.end(), what.begin(), what.end(),
                      std::inserter(out, out.end()));
  return out;
}

// False: there was none.
bool dropRungs(Network& network, const Wires& lost) {
  return std::erase_if(network.rungs, [&lost](const Rung& rung) {
           const auto begin = beginsAt(rung);
           return begin && lost.contains(*begin);
         }) > 0;
}

}  // namespace

Operand branchBehind(Network& network, const Location& at) {
  const Node& last = at.node().kind == NodeKind::Series ? at.node().children.back() : at.node();
  if (at.count == 1 && isBranch(last)) return last.operand;
  if (at.inSeries() && at.end() < at.list->size() && isBranch((*at.list)[at.end()]))
    return (*at.list)[at.end()].operand;
  if (at.count == 1 && at.node().kind == NodeKind::Contact && isWire(at.node().operand) &&
      !at.node().negated && written(network).contains(at.node().operand.number))
    return at.node().operand;
  Node branch;
  branch.kind = NodeKind::Connector;
  branch.operand.kind = OperandKind::Wire;
  branch.operand.number = freshWire(network);
  const Operand wire = branch.operand;
  insertBehind(at, std::move(branch));
  return wire;
}

std::vector<Node>* logicOfArgument(const Network& network, Node& call, std::size_t argument) {
  Argument& meant = call.arguments[argument];
  if (!meant.bit || meant.output) return nullptr;
  std::size_t before = 0;  // parameters of earlier arguments
  for (std::size_t i = 0; i <= argument; ++i)
    for (Pin& parameter : call.parameters) {
      if (call.arguments[i].wire != parameter.operand.number) continue;
      if (i == argument) return &parameter.logic;
      ++before;
    }
  Pin parameter;
  parameter.operand.kind = OperandKind::Wire;
  parameter.operand.number = freshWire(network);
  meant.wire = parameter.operand.number;
  const auto place = call.parameters.begin() + static_cast<std::ptrdiff_t>(before);
  return &call.parameters.insert(place, std::move(parameter))->logic;
}

Node wireContact(const Operand& wire) {
  Node node;
  node.kind = NodeKind::Contact;
  node.operand = wire;
  return node;
}

std::size_t behindBranches(const Network& network, std::size_t rung) {
  Wires wires;
  addWritten(network.rungs[rung], wires);
  return behind(network, rung, std::move(wires));
}

std::size_t behindBranch(const Network& network, std::size_t rung, const Operand& wire) {
  std::vector<std::uint32_t> all;
  for (const Node& node : network.rungs[rung].logic) collectWires(node, all);
  const auto at = std::find(all.begin(), all.end(), wire.number);
  Wires wires(at, all.end());
  wires.insert(wire.number);
  return behind(network, rung, std::move(wires));
}

Network withFreshWires(Network fragment, const Network& network) {
  dropReads(fragment, difference(readWires(fragment), written(fragment)));
  const std::uint32_t offset = freshWire(network) + kBehindAll;
  const auto renumber = [offset](Operand& operand) {
    if (isWire(operand)) operand.number += offset;
  };
  for (Rung& rung : fragment.rungs)
    for (Coil& coil : rung.coils) renumber(coil.operand);
  changeNodes(fragment, [&](Node& node) {
    renumber(node.operand);
    for (Pin& parameter : node.parameters) parameter.operand.number += offset;
    for (Argument& argument : node.arguments)
      if (argument.wire >= 0) argument.wire += offset;
  });
  return fragment;
}

Network separated(Network fragment) {
  dropReads(fragment, readWires(fragment));
  for (Rung& rung : fragment.rungs)
    change(rung.logic, [](std::vector<Node>& nodes) { std::erase_if(nodes, isBranch); });
  return fragment;
}

void tidyBranches(Network& network, const Network& before) {
  const Wires writtenBefore = written(before), readBefore = readWires(before);
  Wires lost = difference(writtenBefore, written(network));
  while (dropRungs(network, lost)) lost = difference(writtenBefore, written(network));
  dropReads(network, lost);
  const Wires unread = difference(readBefore, readWires(network));
  for (Rung& rung : network.rungs)
    change(rung.logic, [&unread](std::vector<Node>& nodes) {
      std::erase_if(nodes, [&unread](const Node& node) {
        return isBranch(node) && unread.contains(node.operand.number);
      });
    });
}

}  // namespace merker::graph
