#include "graph/branches.h"

#include <map>
#include <optional>
#include <set>

#include "graph/kinds.h"
#include "graph/wires.h"

namespace merker::graph {
namespace {

// Wires that a contact in the middle of some logic reads: they need their name in the picture.
using Named = std::set<std::uint32_t>;

bool isJoint(const Node& node, const Named& named) {
  return isBranch(node) && !named.contains(node.operand.number);
}

Node contactOf(const Node& connector) {
  Node node;
  node.kind = NodeKind::Contact;
  node.operand = connector.operand;
  node.continues = true;
  node.first = connector.first;
  node.last = connector.last;
  return node;
}

// The one node that stands first in it, or null.
template <typename N>
N* leading(N& node) {
  if (node.kind == NodeKind::Series && !node.children.empty()) return &node.children.front();
  if (node.kind != NodeKind::Box) return nullptr;
  if (!node.enable.empty()) return &node.enable.front();
  return !node.pins.empty() && !node.pins.front().logic.empty() ? &node.pins.front().logic.front()
                                                                : nullptr;
}

// The contact in which the node begins.
template <typename N>
N* firstOf(N& node) {
  if (node.kind == NodeKind::Contact) return &node;
  N* first = leading(node);
  if (first == nullptr && !node.children.empty()) first = &node.children.front();
  return first == nullptr ? nullptr : firstOf(*first);
}

// Divides the node at its first branch: what stands before it is returned, the node keeps what goes
// on from there. Nothing if there is no branch.
std::optional<Node> splitAtBranch(Node& node, const Named& named) {
  if (Node* first = leading(node))
    if (auto head = splitAtBranch(*first, named)) return head;
  if (node.kind != NodeKind::Series) return std::nullopt;
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    if (!isJoint(node.children[i], named)) continue;
    Node head = node, wire = contactOf(node.children[i]);
    const auto at = static_cast<std::ptrdiff_t>(i);
    head.children.assign(node.children.begin(), node.children.begin() + at);
    node.children.erase(node.children.begin(), node.children.begin() + at);
    node.children.front() = std::move(wire);
    return head;
  }
  return std::nullopt;
}

// Branches within each other; deeper ones are drawn as connectors.
constexpr int kDeepest = 50;

// The contact with which a rung goes on where another one branches, if it does.
const Node* trunkContact(const Rung& rung) {
  const Node* node = rung.logic.empty() ? nullptr : &rung.logic.front();
  while (node != nullptr && node->kind != NodeKind::Contact) node = leading(*node);
  return node != nullptr && isWire(node->operand) ? node : nullptr;
}

std::optional<std::uint32_t> assignedWire(const Coil& coil) {
  if (coil.element->items.front().op != Op::ASSIGN || !isWire(coil.operand)) return std::nullopt;
  return coil.operand.number;
}

// Wires that a coil writes and with which later rungs begin, and nothing else is done with: the
// rung branches there, too, as it does where its first branch is in brackets.
class CoilBranches {
 public:
  explicit CoilBranches(const Network& network) {
    for (const Rung& rung : network.rungs) {
      reads(rung);
      for (const Node& logic : rung.logic) collectWires(logic, connected_);
      for (const Coil& coil : rung.coils)
        if (const auto wire = assignedWire(coil)) ++written_[*wire];
    }
    for (const std::uint32_t wire : connected_) ++written_[wire];
  }

  bool contains(const Coil& coil) const {
    const auto wire = assignedWire(coil);
    if (!wire || elsewhere_.contains(*wire) || !continued_.contains(*wire)) return false;
    return written_.at(*wire) == 1;
  }

 private:
  // A wire that is read before it is written holds what the last cycle left.
  void reads(const Rung& rung) {
    const Node* trunk = trunkContact(rung);
    for (const Node& logic : rung.logic)
      visit(logic, [this, trunk](const Node& node) {
        if (node.kind != NodeKind::Contact || !isWire(node.operand)) return;
        const std::uint32_t wire = node.operand.number;
        (&node == trunk && written_.contains(wire) ? continued_ : elsewhere_).insert(wire);
      });
  }

  std::map<std::uint32_t, int> written_;
  std::set<std::uint32_t> continued_, elsewhere_;
  std::vector<std::uint32_t> connected_;
};

class Builder {
 public:
  std::vector<std::unique_ptr<Path>> build(const Network& network) {
    const CoilBranches branches(network);
    for (const Rung& rung : network.rungs)
      for (const Node& node : rung.logic) findNamed(node);
    for (const Rung& rung : network.rungs) {
      std::vector<Node> logic = rung.logic;
      const auto [siblings, depth] = siblingsOf(logic);
      siblings->push_back(path(std::move(logic), rung.coils, depth));
      branchAtCoils(*siblings->back(), branches);
    }
    return std::move(roots_);
  }

 private:
  // What stands at the end of the rung is where others go on.
  void branchAtCoils(Path& path, const CoilBranches& branches) {
    if (!path.tails.empty()) return branchAtCoils(*path.tails.front(), branches);
    if (path.depth >= kDeepest) return;
    std::erase_if(path.coils, [&](const Coil& coil) {
      const bool branch = branches.contains(coil);
      if (branch) branches_[coil.operand.number] = &path;
      return branch;
    });
  }

  void findNamed(const Node& logic) {
    const Node* first = firstContact(logic);
    visit(logic, [this, first](const Node& node) {
      if (&node != first && node.kind == NodeKind::Contact &&
          node.operand.kind == OperandKind::Wire)
        named_.insert(node.operand.number);
    });
  }

  struct Siblings {
    std::vector<std::unique_ptr<Path>>* paths;
    int depth;
  };

  // The branch from which the logic goes on; its first contact is marked then.
  Siblings siblingsOf(std::vector<Node>& logic) {
    Node* first = logic.empty() ? nullptr : firstOf(logic.front());
    if (first == nullptr || first->operand.kind != OperandKind::Wire) return {&roots_, 0};
    const auto branch = branches_.find(first->operand.number);
    if (branch == branches_.end()) return {&roots_, 0};
    first->continues = true;
    return {&branch->second->tails, branch->second->depth + 1};
  }

  std::unique_ptr<Path> path(std::vector<Node> logic, const std::vector<Coil>& coils, int depth) {
    auto out = std::make_unique<Path>();
    out->depth = depth;
    if (!logic.empty() && depth < kDeepest)
      if (auto head = splitAtBranch(logic.front(), named_)) {
        const std::uint32_t wire = firstContact(logic.front())->operand.number;
        out->logic.push_back(std::move(*head));
        branches_[wire] = out.get();
        out->tails.push_back(path(std::move(logic), coils, depth + 1));
        return out;
      }
    out->logic = std::move(logic);
    out->coils = coils;
    return out;
  }

  std::vector<std::unique_ptr<Path>> roots_;
  std::map<std::uint32_t, Path*> branches_;
  Named named_;
};

}  // namespace

const Node* firstContact(const Node& node) { return firstOf(node); }

std::vector<std::unique_ptr<Path>> paths(const Network& network) {
  return Builder().build(network);
}

}  // namespace merker::graph
