#include "graph/edit_insert.h"

#include <algorithm>

#include "graph/edit_branches.h"
#include "graph/edit_place.h"
#include "graph/kinds.h"
#include "graph/missing.h"
#include "graph/new_element.h"
#include "graph/simplify.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

bool isMissingContact(const Node& node) {
  return node.kind == NodeKind::Contact && isMissing(node.operand);
}

class Inserter {
 public:
  Inserter(Network& network, const Edit& edit, const Rules& rules)
      : network_(network), edit_(edit), rules_(rules) {}

  Refused insert(const std::optional<Location>& at) {
    if (const auto kind = gateKind(edit_.element, rules_)) return insertGate(at, *kind);
    if (auto coil = newCoil(edit_, rules_))
      return fits(*coil) ? insertCoil(at, std::move(*coil)) : Refused(EditProblem::NoOperand);
    auto node = newNode(edit_, rules_);
    if (!node) return EditProblem::NoElement;
    if (!fits(*node)) return EditProblem::NoOperand;
    node->selected = true;
    if (!at) return atEnd(std::move(*node));
    if (edit_.place == Place::AtPin) return atPin(*at, std::move(*node));
    if (edit_.place == Place::Branch) return branch(*at, std::move(*node), std::nullopt);
    return at->coil != nullptr ? atCoil(*at, std::move(*node)) : atNode(*at, std::move(*node));
  }

 private:
  std::size_t numberOf(const Rung& rung) const {
    return static_cast<std::size_t>(&rung - network_.rungs.data());
  }
  void addRung(std::size_t at, Rung rung) {
    network_.rungs.insert(network_.rungs.begin() + static_cast<std::ptrdiff_t>(at),
                          std::move(rung));
  }

  // It waits for its coil; behind a box none is needed.
  static bool isUnfinished(const Rung& rung) {
    return rung.coils.empty() && !takesSignal(rung.logic.front());
  }

  // Nodes

  // To a rung that is not finished, or as a new one.
  Refused atEnd(Node node) {
    if (edit_.place == Place::Before && !network_.rungs.empty() &&
        !network_.rungs.front().logic.empty())
      return before(wholeLogic(network_.rungs.front()), std::move(node));
    if (!network_.rungs.empty() && isUnfinished(network_.rungs.back()))
      return behind(wholeLogic(network_.rungs.back()), std::move(node));
    if (actsOnSignal(node)) return EditProblem::Rail;
    Rung rung;
    rung.logic.push_back(std::move(node));
    network_.rungs.push_back(std::move(rung));
    return std::nullopt;
  }

  Refused atCoil(const Location& at, Node node) {
    if (edit_.place == Place::Behind) return EditProblem::BehindCoil;
    if (edit_.place == Place::Parallel) return EditProblem::BranchPlace;
    at.coil->element = &rules_.elements->counterpart(*at.coil->element, true);
    if (isRail(*at.coil)) return EditProblem::CoilPlace;
    if (!at.rung->logic.empty()) return behind(wholeLogic(*at.rung), std::move(node));
    if (actsOnSignal(node)) return EditProblem::Rail;
    at.rung->logic.push_back(std::move(node));
    return std::nullopt;
  }

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

  Refused atNode(const Location& at, Node node) {
    if (isNegation(at, node)) return negate(at.node());
    if (edit_.place == Place::Behind && node.kind == NodeKind::Contact && isMissingAtPin(at)) {
      at.node() = std::move(node);
      return std::nullopt;
    }
    if (edit_.place == Place::Behind) return behind(at, std::move(node));
    if (edit_.place == Place::Before) return before(at, std::move(node));
    if (actsOnSignal(node)) return EditProblem::Rail;
    if (at.count == 1 && actsOnSignal(at.node())) return EditProblem::BranchPlace;
    Node parallel = gate(NodeKind::Parallel, takeOut(at), std::move(node));
    put(at, std::move(parallel));
    return std::nullopt;
  }

  // Pins

  Refused atPin(const Location& at, Node node) {
    std::vector<Node>* logic = nullptr;
    if (const Refused refused = logicOfPin(at, logic)) return refused;
    if (!logic->empty() && !actsOnSignal(node) && isMissingContact(logic->front())) logic->clear();
    if (!logic->empty()) {
      Location whole{.rung = at.rung, .list = logic, .parent = &at.node()};
      return behind(whole, std::move(node));
    }
    if (actsOnSignal(node)) return EditProblem::Rail;
    logic->push_back(std::move(node));
    return std::nullopt;
  }

  Refused logicOfPin(const Location& at, std::vector<Node>*& logic) {
    if (at.list == nullptr || at.node().kind != NodeKind::Box) return EditProblem::NoPin;
    Node& box = at.node();
    const ElementClass kind = box.element->row.kind;
    const bool call = kind == ElementClass::Call;
    if (edit_.at.pin == kEnable) {
      logic = &box.enable;
      return call || kind == ElementClass::Move ? Refused{} : EditProblem::NoPin;
    }
    if (edit_.at.pin < kFirstPin) return EditProblem::NotLogic;
    const auto pin = static_cast<std::size_t>(edit_.at.pin - kFirstPin);
    if (pin >= (call ? box.arguments.size() : box.pins.size())) return EditProblem::NoPin;
    if (call) {
      logic = logicOfArgument(network_, box, pin);
      return logic == nullptr ? EditProblem::NotLogic : Refused{};
    }
    logic = &box.pins[pin].logic;
    return box.element->pins[pin].kind == PinKind::Logic ? Refused{} : EditProblem::NotLogic;
  }

  // Gates

  Refused insertGate(const std::optional<Location>& at, NodeKind kind) {
    Node input = missingContact();
    if (!at && !network_.rungs.empty() && isUnfinished(network_.rungs.back())) {
      input.selected = true;
      wrap(wholeLogic(network_.rungs.back()), kind, std::move(input));
      return std::nullopt;
    }
    if (!at) {
      Rung rung;
      rung.logic.push_back(gate(kind, missingContact(), std::move(input)));
      rung.logic.front().children.front().selected = true;
      network_.rungs.push_back(std::move(rung));
      return std::nullopt;
    }
    input.selected = true;
    if (edit_.place == Place::AtPin) return gateAtPin(*at, kind, std::move(input));
    if (at->coil != nullptr && isRail(*at->coil)) return EditProblem::CoilPlace;
    if (at->coil != nullptr && at->rung->logic.empty()) at->rung->logic.push_back(missingContact());
    wrap(at->coil != nullptr ? wholeLogic(*at->rung) : signalOf(*at), kind, std::move(input));
    return std::nullopt;
  }

  Refused gateAtPin(const Location& at, NodeKind kind, Node input) {
    std::vector<Node>* logic = nullptr;
    if (const Refused refused = logicOfPin(at, logic)) return refused;
    if (logic->empty()) logic->push_back(missingContact());
    wrap({.rung = at.rung, .list = logic, .parent = &at.node()}, kind, std::move(input));
    return std::nullopt;
  }

  // The signal behind NOT, an edge or a connector is that of all before it.
  static Location signalOf(const Location& at) {
    Location out = at;
    if (!at.inSeries() || at.count > 1 || !actsOnSignal(at.node())) return out;
    out.from = 0;
    out.count = at.end();
    return out;
  }

  void wrap(const Location& at, NodeKind kind, Node input) {
    const bool first = edit_.place == Place::Before;
    Node signal = takeOut(at);
    Node group = first ? gate(kind, std::move(input), std::move(signal))
                       : gate(kind, std::move(signal), std::move(input));
    put(at, std::move(group));
  }

  // Coils

  Refused insertCoil(const std::optional<Location>& at, Coil coil) {
    coil.selected = true;
    coil.element = &rules_.elements->counterpart(*coil.element, true);
    if (isRail(coil)) return atRail(at, std::move(coil));
    if (!at) return coilAtEnd(std::move(coil));
    if (edit_.place == Place::Branch) return branch(*at, std::nullopt, std::move(coil));
    if (edit_.place == Place::AtPin) return EditProblem::CoilPlace;
    if (at->coil != nullptr) return besideCoil(*at, std::move(coil));
    if (edit_.place != Place::Behind) return EditProblem::CoilPlace;
    if (at->rung->coils.empty()) {  // whatever is selected, it ends here
      at->rung->coils.push_back(std::move(coil));
      return std::nullopt;
    }
    if (!isTrunk(*at->rung, at->list)) return EditProblem::CoilPlace;
    const bool last =
        at->list == &at->rung->logic ||
        (at->list == &at->rung->logic.front().children && at->end() == at->list->size());
    if (!last) return branch(*at, std::nullopt, std::move(coil));
    at->rung->coils.insert(at->rung->coils.begin(), std::move(coil));
    return std::nullopt;
  }

  Refused atRail(const std::optional<Location>& at, Coil coil) {
    Rung rung;
    rung.coils.push_back(std::move(coil));
    const std::size_t behind =
        at ? behindBranches(network_, numberOf(*at->rung)) : network_.rungs.size();
    if (behind > 0 && isUnfinished(network_.rungs[behind - 1])) return EditProblem::AtRail;
    addRung(behind, std::move(rung));
    return std::nullopt;
  }

  Refused coilAtEnd(Coil coil) {
    const bool unfinished = !network_.rungs.empty() && network_.rungs.back().coils.empty();
    if (!unfinished) network_.rungs.emplace_back();
    network_.rungs.back().coils.push_back(std::move(coil));
    return std::nullopt;
  }

  Refused besideCoil(const Location& at, Coil coil) {
    if (isRail(*at.coil)) return EditProblem::CoilPlace;
    std::vector<Coil>& coils = at.rung->coils;
    const auto place = coils.begin() + (at.coil - coils.data());
    coils.insert(edit_.place == Place::Before ? place : place + 1, std::move(coil));
    return std::nullopt;
  }

  // Branches

  // A rung of its own from a place within another one.
  Refused branch(const Location& at, std::optional<Node> node, std::optional<Coil> coil) {
    if (!rules_.branches || (at.coil != nullptr && at.rung->logic.empty()))
      return EditProblem::BranchPlace;
    const Location from = at.coil != nullptr ? wholeLogic(*at.rung) : at;
    if (!isTrunk(*at.rung, from.list)) return EditProblem::BranchPlace;
    const std::size_t number = numberOf(*at.rung);
    const Operand wire = branchBehind(network_, from);
    Rung rung;
    rung.logic.push_back(wireContact(wire));
    if (coil) rung.coils.push_back(std::move(*coil));
    if (node)
      if (const Refused refused = behind(wholeLogic(rung), std::move(*node))) return refused;
    if (!coil && !takesSignal(rung.logic.front()))
      rung.coils.push_back({rules_.elements->find("COIL"), {}, {}, 0, 0});
    addRung(behindBranch(network_, number, wire), std::move(rung));
    return std::nullopt;
  }

  Network& network_;
  const Edit& edit_;
  const Rules& rules_;
};

}  // namespace

std::optional<EditProblem> insert(Network& network, const std::optional<Location>& at,
                                  const Edit& edit, const Rules& rules) {
  return Inserter(network, edit, rules).insert(at);
}

}  // namespace merker::graph
