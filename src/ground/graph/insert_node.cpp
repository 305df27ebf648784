// Contacts, boxes and what acts on a signal, in series, in parallel and at pins.
#include "graph/edit_branches.h"
#include "graph/edit_insert.h"
#include "graph/edit_place.h"
#include "graph/kinds.h"
#include "graph/missing.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

bool isMissingContact(const Node& node) {
  return node.kind == NodeKind::Contact && isMissing(node.operand);
}

class NodeInserter {
 public:
  explicit NodeInserter(const Editing& editing)
      : editing_(editing), network_(editing.network), edit_(editing.edit) {}

  // To a rung that is not finished, or as a new one.
  Refused atEnd(Node node) {
    std::vector<Rung>& rungs = network_.rungs;
    if (edit_.place == Place::Before && !rungs.empty() && !rungs.front().logic.empty())
      return before(wholeLogic(rungs.front()), std::move(node));
    if (!rungs.empty() && isUnfinished(rungs.back()))
      return behind(wholeLogic(rungs.back()), std::move(node));
    if (beginsOnSignal(node)) return EditProblem::Rail;
    Rung rung;
    rung.logic.push_back(std::move(node));
    rungs.push_back(std::move(rung));
    return std::nullopt;
  }

  // In series with all that goes to the coil: nothing can stand behind it.
  Refused atCoil(const Location& at, Node node) {
    if (edit_.place == Place::Parallel) return EditProblem::BranchPlace;
    at.coil->element = &editing_.rules.elements->counterpart(*at.coil->element, true);
    if (isRail(*at.coil)) return EditProblem::RailCoil;
    const bool acts = beginsOnSignal(node);
    if (!acts && !at.rung->logic.empty() && isMissingContact(at.rung->logic.front()))
      at.rung->logic.clear();
    if (!at.rung->logic.empty()) return behind(wholeLogic(*at.rung), std::move(node));
    if (acts) return EditProblem::Rail;
    at.rung->logic.push_back(std::move(node));
    return std::nullopt;
  }

  Refused atNode(const Location& at, Node node) {
    if (isNegation(at, node)) return negate(at.node());
    if (edit_.place == Place::Behind && node.kind == NodeKind::Contact && isMissingAtPin(at)) {
      at.node() = std::move(node);
      return std::nullopt;
    }
    if (edit_.place == Place::Behind) return behind(at, std::move(node));
    if (edit_.place == Place::Before) return before(at, std::move(node));
    if (beginsOnSignal(node)) return EditProblem::Rail;
    if (at.count == 1 && actsOnSignal(at.node())) return EditProblem::BranchPlace;
    Node parallel = gate(NodeKind::Parallel, takeOut(at), std::move(node));
    put(at, std::move(parallel));
    return std::nullopt;
  }

  Refused atPin(const Location& at, Node node) {
    std::vector<Node>* logic = nullptr;
    if (const Refused refused = logicAtPin(editing_, at, logic)) return refused;
    if (!logic->empty() && !beginsOnSignal(node) && isMissingContact(logic->front()))
      logic->clear();
    if (!logic->empty()) {
      const Location whole{.rung = at.rung, .list = logic, .parent = &at.node()};
      return behind(whole, std::move(node));
    }
    if (beginsOnSignal(node)) return EditProblem::Rail;
    logic->push_back(std::move(node));
    return std::nullopt;
  }

 private:
  // NOT at an input of a gate is the circle of this input; in a series it turns all before it.
  bool isNegation(const Location& at, const Node& node) const {
    if (node.kind != NodeKind::Not || at.count > 1 || at.node().kind != NodeKind::Contact)
      return false;
    const bool joined = at.parent != nullptr &&
                        (at.parent->kind == NodeKind::Parallel || at.parent->kind == NodeKind::Xor);
    return joined || edit_.at.pin == kOwn;
  }
  static Refused negate(Node& contact) {
    contact.negated = !contact.negated;
    contact.selected = true;
    return std::nullopt;
  }

  // At a pin where the signal does not come from the rail.
  static bool isMissingAtPin(const Location& at) {
    return at.parent != nullptr && at.parent->kind == NodeKind::Box && at.count == 1 &&
           isMissingContact(at.node()) && !isTrunk(*at.rung, at.list);
  }

  const Editing& editing_;
  Network& network_;
  const Edit& edit_;
};

}  // namespace

std::optional<EditProblem> insertNode(const Editing& editing, const std::optional<Location>& at,
                                      Node node) {
  NodeInserter inserter(editing);
  const Place place = editing.edit.place;
  if (!at) return inserter.atEnd(std::move(node));
  if (place == Place::AtPin) return inserter.atPin(*at, std::move(node));
  if (place == Place::Branch) return insertBranch(editing, *at, std::move(node), std::nullopt);
  return at->coil != nullptr ? inserter.atCoil(*at, std::move(node))
                             : inserter.atNode(*at, std::move(node));
}

Refused logicAtPin(const Editing& editing, const Location& at, std::vector<Node>*& logic) {
  if (at.list == nullptr || at.node().kind != NodeKind::Box) return EditProblem::NoPin;
  Node& box = at.node();
  const ElementClass kind = box.element->row.kind;
  const bool call = kind == ElementClass::Call;
  if (editing.edit.at.pin == kEnable) {
    logic = &box.enable;
    return call || kind == ElementClass::Move ? Refused{} : EditProblem::NoPin;
  }
  if (editing.edit.at.pin < kFirstPin) return EditProblem::NotLogic;
  const auto pin = static_cast<std::size_t>(editing.edit.at.pin - kFirstPin);
  if (pin >= (call ? box.arguments.size() : box.pins.size())) return EditProblem::NoPin;
  if (call) {
    logic = logicOfArgument(editing.network, box, pin);
    return logic == nullptr ? EditProblem::NotLogic : Refused{};
  }
  logic = &box.pins[pin].logic;
  return box.element->pins[pin].kind == PinKind::Logic ? Refused{} : EditProblem::NotLogic;
}

}  // namespace merker::graph
