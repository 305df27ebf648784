#include "networks/source_edit.h"

#include <algorithm>

#include "base/text.h"
#include "graph/locate.h"
#include "networks/tree_edit.h"

namespace merker::networks {
namespace {

bool renamesCall(const graph::Edit& edit, graph::Network tree) {
  if (edit.action != graph::Action::SetOperand || edit.at.pin != graph::kOwn) return false;
  const auto at = graph::locate(tree, edit.at);
  return at && at->coil == nullptr && at->node().kind == graph::NodeKind::Box &&
         at->node().element->row.kind == graph::ElementClass::Call;
}

// What is put in, or whose field is set; null: none of the rows.
const graph::Element* elementOf(const graph::Edit& edit, graph::Network tree,
                                const graph::Rules& rules) {
  if (edit.action == graph::Action::Insert) return rules.elements->find(edit.element);
  const auto at = graph::locate(tree, edit.at);
  return at && at->coil != nullptr ? at->coil->element : nullptr;
}

bool jumps(const graph::Element* element) {
  return element != nullptr && std::any_of(element->items.begin(), element->items.end(),
                                           [](const auto& item) { return graph::isJump(item.op); });
}

bool areLabels(const std::vector<graph::Operand>& operands) {
  return std::all_of(operands.begin(), operands.end(), [](const graph::Operand& operand) {
    return operand.kind != graph::OperandKind::Label || isLabel(operand.text);
  });
}

graph::Operand labelOperand(const std::string& text) {
  graph::Operand operand;
  operand.kind = graph::OperandKind::Label;
  operand.code = operand.text = trim(text);
  return operand;
}

// The edit with its operands as the text would have them.
std::optional<graph::Edit> resolved(graph::Edit edit, const graph::Network& tree, Found& found) {
  const bool label = jumps(elementOf(edit, tree, *found.block.rules));
  for (graph::Operand& operand : edit.operands) {
    if (operand.text.empty()) continue;
    if (label) {
      operand = labelOperand(operand.text);
      continue;
    }
    auto read = found.text->operand(found.index, operand.text);
    if (!read) return std::nullopt;
    operand = std::move(*read);
  }
  const bool call = edit.element == "CALL_BOX" || renamesCall(edit, tree);
  if (call && !edit.operands.empty() && edit.arguments.empty())
    edit.arguments = found.text->parameters(found.index, edit.operands.front().text);
  return edit;
}

}  // namespace

Edited edit(const source::SourceFile& file, std::uint32_t line, std::size_t network,
            const graph::Edit& wish, const Surroundings& around) {
  auto found = findBlock(file, line, around);
  const Network* old = networkOf(found, network);
  if (old == nullptr) return Refusal{};
  if (!old->tree) return Refusal{Obstacle::Awl};
  const auto own = resolved(wish, *old->tree, *found);
  if (!own) return Refusal{Obstacle::Text};
  if (!areLabels(own->operands)) return Refusal{Obstacle::Label};
  return treeEdit(file, *found, network, *own, around);
}

}  // namespace merker::networks
