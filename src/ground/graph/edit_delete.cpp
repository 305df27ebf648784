#include "graph/edit_delete.h"

#include <algorithm>

#include "graph/edit_branches.h"
#include "graph/edit_operand.h"
#include "graph/edit_place.h"
#include "graph/missing.h"
#include "graph/simplify.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

auto placeOf(Network& network, const Rung& rung) {
  return network.rungs.begin() + (&rung - network.rungs.data());
}

// Nothing in it was ever written: it need not stay.
bool isBlank(const Rung& rung) {
  const auto blankCoil = [](const Coil& coil) { return isMissing(coil.operand); };
  const bool blank = rung.logic.empty() || (rung.logic.front().kind == NodeKind::Contact &&
                                            isMissing(rung.logic.front().operand));
  return blank && std::all_of(rung.coils.begin(), rung.coils.end(), blankCoil);
}

Refused removeFromPin(Node& box, int pin) {
  const auto number = static_cast<std::size_t>(pin - kFirstPin);
  if (std::vector<Node>* logic = logicOfPin(box, pin)) logic->clear();
  if (pin == kEnable) return std::nullopt;
  if (box.element->row.kind == ElementClass::Call) {
    if (number >= box.arguments.size()) return EditProblem::NoPin;
    box.arguments[number].text.clear();
  } else {
    if (number >= box.pins.size()) return EditProblem::NoPin;
    box.pins[number].operand = {};
  }
  return std::nullopt;
}

// What the user goes on with when these are gone.
void selectBeside(const Location& at) {
  std::vector<Node>* signal = at.count == 1 ? signalInto(at.node()) : nullptr;
  if (signal != nullptr && !signal->empty())
    signal->front().selected = true;
  else if (at.from > 0)
    (*at.list)[at.from - 1].selected = true;
  else if (at.end() < at.list->size())
    (*at.list)[at.end()].selected = true;
  else if (at.parent != nullptr && at.parent->kind == NodeKind::Box)
    at.parent->selected = true;
  else if (!at.rung->coils.empty())
    at.rung->coils.front().selected = true;
}

}  // namespace

std::optional<EditProblem> remove(Network& network, const Location& at, int pin) {
  if (at.coil == nullptr && (pin >= kFirstPin || pin == kEnable)) {
    if (at.node().kind != NodeKind::Box) return EditProblem::NoPin;
    at.node().selected = true;
    return removeFromPin(at.node(), pin);
  }
  if (isBlank(*at.rung)) {
    removeRung(network, *at.rung);
  } else if (at.coil != nullptr) {
    const std::vector<Coil>& coils = at.rung->coils;
    takeElement(at);
    if (!coils.empty())
      at.rung->coils.front().selected = true;
    else if (!at.rung->logic.empty())
      at.rung->logic.front().selected = true;
  } else {
    selectBeside(at);
    takeElement(at);
  }
  return std::nullopt;
}

void takeElement(const Location& at) {
  if (at.coil != nullptr) {
    std::vector<Coil>& coils = at.rung->coils;
    coils.erase(coils.begin() + (at.coil - coils.data()));
    return;
  }
  Node element = takeOut(at);
  std::vector<Node>* signal = signalInto(element);
  if (signal != nullptr && !signal->empty()) put(at, std::move(signal->front()));
}

void removeRung(Network& network, const Rung& rung) { network.rungs.erase(placeOf(network, rung)); }

void newRung(Network& network, const std::optional<Location>& at, const Rules& rules) {
  Rung rung;
  rung.logic.push_back(missingContact());
  rung.logic.front().selected = true;
  rung.coils.push_back({rules.elements->find("COIL"), {}, {}, 0, 0});
  const std::size_t place =
      at ? behindBranches(network, static_cast<std::size_t>(at->rung - network.rungs.data()))
         : network.rungs.size();
  network.rungs.insert(network.rungs.begin() + static_cast<std::ptrdiff_t>(place), std::move(rung));
}

}  // namespace merker::graph
