// Coils, and rungs that branch off from others.
#include "graph/edit_branches.h"
#include "graph/edit_insert.h"
#include "graph/edit_place.h"
#include "graph/kinds.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

void addRung(Network& network, std::size_t at, Rung rung) {
  network.rungs.insert(network.rungs.begin() + static_cast<std::ptrdiff_t>(at), std::move(rung));
}

Refused atRail(Network& network, const std::optional<Location>& at, Coil coil) {
  Rung rung;
  rung.coils.push_back(std::move(coil));
  const std::size_t behind =
      at ? behindBranches(network, numberOf(network, *at->rung)) : network.rungs.size();
  if (behind > 0 && isUnfinished(network.rungs[behind - 1])) return EditProblem::AtRail;
  addRung(network, behind, std::move(rung));
  return std::nullopt;
}

Refused coilAtEnd(Network& network, Coil coil) {
  const bool unfinished = !network.rungs.empty() && network.rungs.back().coils.empty();
  if (!unfinished) network.rungs.emplace_back();
  network.rungs.back().coils.push_back(std::move(coil));
  return std::nullopt;
}

Refused besideCoil(const Location& at, Coil coil, Place side) {
  if (isRail(*at.coil)) return EditProblem::CoilPlace;
  std::vector<Coil>& coils = at.rung->coils;
  const auto place = coils.begin() + (at.coil - coils.data());
  coils.insert(side == Place::Before ? place : place + 1, std::move(coil));
  return std::nullopt;
}

Refused behindNode(const Editing& editing, const Location& at, Coil coil) {
  if (at.rung->coils.empty()) {  // whatever is selected, it ends here
    at.rung->coils.push_back(std::move(coil));
    return std::nullopt;
  }
  if (!isTrunk(*at.rung, at.list)) return EditProblem::CoilPlace;
  const bool last = at.list == &at.rung->logic ||
                    (at.list == &at.rung->logic.front().children && at.end() == at.list->size());
  if (!last) return insertBranch(editing, at, std::nullopt, std::move(coil));
  at.rung->coils.insert(at.rung->coils.begin(), std::move(coil));
  return std::nullopt;
}

}  // namespace

std::optional<EditProblem> insertCoil(const Editing& editing, const std::optional<Location>& at,
                                      Coil coil) {
  const Place place = editing.edit.place;
  coil.selected = true;
  coil.element = &editing.rules.elements->counterpart(*coil.element, true);
  if (isRail(coil)) return atRail(editing.network, at, std::move(coil));
  if (!at) return coilAtEnd(editing.network, std::move(coil));
  if (place == Place::Branch) return insertBranch(editing, *at, std::nullopt, std::move(coil));
  if (place == Place::AtPin) return EditProblem::CoilPlace;
  if (at->coil != nullptr) return besideCoil(*at, std::move(coil), place);
  if (place != Place::Behind) return EditProblem::CoilPlace;
  return behindNode(editing, *at, std::move(coil));
}

std::optional<EditProblem> insertBranch(const Editing& editing, const Location& at,
                                        std::optional<Node> node, std::optional<Coil> coil) {
  if (!editing.rules.branches || (at.coil != nullptr && at.rung->logic.empty()))
    return EditProblem::BranchPlace;
  const Location from = at.coil != nullptr ? wholeLogic(*at.rung) : at;
  if (!isTrunk(*at.rung, from.list)) return EditProblem::BranchPlace;
  const std::size_t number = numberOf(editing.network, *at.rung);
  const Operand wire = branchBehind(editing.network, from);
  Rung rung;
  rung.logic.push_back(wireContact(wire));
  if (coil) rung.coils.push_back(std::move(*coil));
  if (node)
    if (const Refused refused = behind(wholeLogic(rung), std::move(*node))) return refused;
  if (!coil && !takesSignal(rung.logic.front()))
    rung.coils.push_back({editing.rules.elements->find("COIL"), {}, {}, 0, 0});
  addRung(editing.network, behindBranch(editing.network, number, wire), std::move(rung));
  return std::nullopt;
}

}  // namespace merker::graph
