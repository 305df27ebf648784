#include "graph/edit_insert.h"

#include "graph/kinds.h"
#include "graph/new_element.h"

namespace merker::graph {

bool isUnfinished(const Rung& rung) {
  return rung.coils.empty() && !rung.logic.empty() && !takesSignal(rung.logic.front());
}

std::size_t numberOf(const Network& network, const Rung& rung) {
  return static_cast<std::size_t>(&rung - network.rungs.data());
}

std::optional<EditProblem> insert(const Editing& editing, const std::optional<Location>& at) {
  const Edit& edit = editing.edit;
  if (const auto kind = gateKind(edit.element, editing.rules))
    return insertGate(editing, at, *kind);
  if (auto coil = newCoil(edit, editing.rules)) {
    if (!fits(*coil)) return EditProblem::NoOperand;
    return insertCoil(editing, at, std::move(*coil));
  }
  auto node = newNode(edit, editing.rules);
  if (!node) return EditProblem::NoElement;
  if (!fits(*node)) return EditProblem::NoOperand;
  node->selected = true;
  return insertNode(editing, at, std::move(*node));
}

}  // namespace merker::graph
