// The gates of FUP.
#include "graph/edit_insert.h"
#include "graph/edit_place.h"
#include "graph/kinds.h"
#include "graph/simplify.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

void wrap(const Editing& editing, const Location& at, NodeKind kind) {
  Node input = missingContact();
  input.selected = true;
  Node signal = takeOut(at);
  Node group = editing.edit.place == Place::Before
                   ? gate(kind, std::move(input), std::move(signal))
                   : gate(kind, std::move(signal), std::move(input));
  put(at, std::move(group));
}

// Of the rung that is not finished, or a new one.
void gateAtEnd(const Editing& editing, NodeKind kind) {
  std::vector<Rung>& rungs = editing.network.rungs;
  if (!rungs.empty() && isUnfinished(rungs.back()))
    return wrap(editing, wholeLogic(rungs.back()), kind);
  Rung rung;
  rung.logic.push_back(gate(kind, missingContact(), missingContact()));
  rung.logic.front().children.front().selected = true;
  rungs.push_back(std::move(rung));
}

Refused gateAtPin(const Editing& editing, const Location& at, NodeKind kind) {
  std::vector<Node>* logic = nullptr;
  if (const Refused refused = logicAtPin(editing, at, logic)) return refused;
  if (logic->empty()) logic->push_back(missingContact());
  wrap(editing, {.rung = at.rung, .list = logic, .parent = &at.node()}, kind);
  return std::nullopt;
}

// The signal behind NOT, an edge or a connector is that of all before it.
Location signalOf(const Location& at) {
  Location out = at;
  if (!at.inSeries() || at.count > 1 || !actsOnSignal(at.node())) return out;
  out.from = 0;
  out.count = at.end();
  return out;
}

}  // namespace

std::optional<EditProblem> insertGate(const Editing& editing, const std::optional<Location>& at,
                                      NodeKind kind) {
  if (!at) {
    gateAtEnd(editing, kind);
    return std::nullopt;
  }
  if (editing.edit.place == Place::AtPin) return gateAtPin(editing, *at, kind);
  if (at->coil == nullptr) {
    wrap(editing, signalOf(*at), kind);
    return std::nullopt;
  }
  at->coil->element = &editing.rules.elements->counterpart(*at->coil->element, true);
  if (isRail(*at->coil)) return EditProblem::RailCoil;
  if (at->rung->logic.empty()) at->rung->logic.push_back(missingContact());
  wrap(editing, wholeLogic(*at->rung), kind);
  return std::nullopt;
}

}  // namespace merker::graph
