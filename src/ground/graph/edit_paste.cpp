#include "graph/edit_paste.h"

#include <algorithm>

#include "graph/canonical.h"
#include "graph/edit_branches.h"
#include "graph/edit_delete.h"
#include "graph/edit_place.h"
#include "graph/kinds.h"
#include "graph/missing.h"
#include "graph/wires.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

// Several elements beside each other are an element, too: a gate of FUP.
Node elementAt(const Location& at) {
  if (at.count == 1) {
    Node element = at.node();
    if (std::vector<Node>* signal = signalInto(element)) signal->clear();
    return element;
  }
  Node series;
  series.children.assign(iterator(*at.list, at.from), iterator(*at.list, at.end()));
  series.first = series.children.front().first;
  series.last = series.children.back().last;
  return series;
}

bool isTied(const Node& element) {
  bool tied = false;
  visit(element, [&tied](const Node& node) {
    tied = tied || isBranch(node) || (node.kind == NodeKind::Contact && isWire(node.operand));
  });
  return tied;
}

Rung rungOf(std::vector<Node> nodes, std::vector<Coil> coils) {
  Rung rung;
  rung.coils = std::move(coils);
  if (nodes.size() == 1) rung.logic = std::move(nodes);
  if (nodes.size() < 2) return rung;
  rung.logic.emplace_back().children = std::move(nodes);
  return rung;
}

// NOT, an edge or a connector was copied with a contact that stands for what is before it.
void dropStandIn(std::vector<Node>& logic) {
  if (logic.empty() || logic.front().kind != NodeKind::Series) return;
  std::vector<Node>& children = logic.front().children;
  if (children.size() > 1 && children[0].kind == NodeKind::Contact &&
      isMissing(children[0].operand) && actsOnSignal(children[1]))
    children.erase(children.begin());
}

Coil* selectedCoil(Rung& rung) {
  const auto at = std::find_if(rung.coils.begin(), rung.coils.end(),
                               [](const Coil& coil) { return coil.selected; });
  return at == rung.coils.end() ? nullptr : &*at;
}

std::optional<Location> selectedCoil(Network& network) {
  for (Rung& rung : network.rungs)
    if (Coil* coil = selectedCoil(rung)) return Location{.rung = &rung, .coil = coil};
  return std::nullopt;
}

// One beside the other.
Refused pasteCoils(const Editing& editing, std::optional<Location> at, std::vector<Coil> coils) {
  Edit beside = editing.edit;
  for (Coil& coil : coils) {
    if (const Refused refused =
            insertCoil({editing.network, beside, editing.rules}, at, std::move(coil)))
      return refused;
    at = selectedCoil(editing.network);
    beside.place = Place::Behind;
    if (&coil != &coils.back()) at->coil->selected = false;
  }
  return std::nullopt;
}

void pasteRungs(Network& network, const std::optional<Location>& at, std::vector<Rung> rungs) {
  Rung& last = rungs.back();
  (last.coils.empty() ? last.logic.front().selected : last.coils.back().selected) = true;
  const std::size_t place =
      at ? behindBranches(network, numberOf(network, *at->rung)) : network.rungs.size();
  network.rungs.insert(network.rungs.begin() + static_cast<std::ptrdiff_t>(place),
                       std::make_move_iterator(rungs.begin()),
                       std::make_move_iterator(rungs.end()));
}

}  // namespace

std::optional<Network> copied(const Network& network, std::span<const Selection> elements,
                              const Rules& rules, std::uint32_t firstWire) {
  Network from = network;
  std::vector<Node> nodes;
  std::vector<Coil> coils;
  for (const Selection& element : elements) {
    const auto at = locate(from, element);
    if (!at) return std::nullopt;
    if (at->coil != nullptr)
      coils.push_back(*at->coil);
    else
      nodes.push_back(elementAt(*at));
  }
  const auto inOrder = [](const auto& a, const auto& b) { return a.last < b.last; };
  std::sort(nodes.begin(), nodes.end(), inOrder);
  std::sort(coils.begin(), coils.end(), inOrder);
  Network out;
  out.rungs.push_back(rungOf(std::move(nodes), std::move(coils)));
  return canonical(separated(std::move(out)), rules, firstWire, Unfinished::Part);
}

bool carriesBranch(const Network& network, const Selection& element) {
  Network from = network;
  const auto at = locate(from, element);
  return at && at->coil == nullptr && isTied(elementAt(*at));
}

std::optional<EditProblem> paste(const Editing& editing, const std::optional<Location>& at) {
  Network pasted = withFreshWires(editing.edit.pasted, editing.network);
  if (pasted.rungs.empty()) return EditProblem::NoElement;
  Rung& only = pasted.rungs.front();
  if (pasted.rungs.size() == 1 && only.logic.empty())
    return pasteCoils(editing, at, std::move(only.coils));
  if (pasted.rungs.size() == 1 && only.coils.empty()) {
    dropStandIn(only.logic);
    only.logic.front().bracketed = false;
    only.logic.front().selected = true;
    return insertNode(editing, at, std::move(only.logic.front()));
  }
  pasteRungs(editing.network, at, std::move(pasted.rungs));
  return std::nullopt;
}

std::optional<EditProblem> move(const Editing& editing) {
  const auto from = locate(editing.network, editing.edit.from);
  if (!from) return EditProblem::NoNode;
  if (from->coil != nullptr) {
    if (editing.edit.from == editing.edit.at) return std::nullopt;
    Coil coil = *from->coil;
    takeElement(*from);
    const auto at = locate(editing.network, editing.edit.at);
    if (!at && editing.edit.at.node >= 0) return EditProblem::NoNode;
    return insertCoil(editing, at, std::move(coil));
  }
  if (carriesBranch(editing.network, editing.edit.from)) return EditProblem::WithBranch;
  Network moved;
  moved.rungs.push_back(rungOf({elementAt(*from)}, {}));
  Node& element = moved.rungs.front().logic.front();
  if (locate(moved, editing.edit.at))
    return editing.edit.from == editing.edit.at ? Refused{} : EditProblem::Inside;
  takeElement(*from);
  const auto at = locate(editing.network, editing.edit.at);
  if (!at && editing.edit.at.node >= 0) return EditProblem::NoNode;
  element.selected = true;
  element.bracketed = isGroup(element);
  return insertNode(editing, at, std::move(element));
}

}  // namespace merker::graph
