#include "graph/new_element.h"

#include <algorithm>

namespace merker::graph {
namespace {

struct LeafRow {
  std::string_view element;
  NodeKind kind;
  bool flag;      // negated, falling
  bool extended;  // not in every family
};
constexpr LeafRow kLeaves[] = {
    {element::kContact, NodeKind::Contact, false, false},
    {element::kContactNot, NodeKind::Contact, true, false},
    {element::kNot, NodeKind::Not, false, true},
    {element::kRisingEdge, NodeKind::Edge, false, true},
    {element::kFallingEdge, NodeKind::Edge, true, true},
    {element::kRisingOperand, NodeKind::OperandEdge, false, true},
    {element::kFallingOperand, NodeKind::OperandEdge, true, true},
    {element::kConnector, NodeKind::Connector, false, false},
};

struct GateRow {
  std::string_view element;
  NodeKind kind;
};
constexpr GateRow kGates[] = {{element::kAnd, NodeKind::Series},
                              {element::kOr, NodeKind::Parallel},
                              {element::kXor, NodeKind::Xor}};

Operand field(const Edit& edit, int number) {
  const auto at = static_cast<std::size_t>(number);
  return at < edit.operands.size() ? edit.operands[at] : Operand{};
}

Node leaf(const LeafRow& row, const Edit& edit) {
  Node node;
  node.kind = row.kind;
  if (row.kind == NodeKind::Contact)
    node.negated = row.flag;
  else
    node.falling = row.flag;
  if (row.kind == NodeKind::Edge)
    node.memory = field(edit, kOwn);
  else if (row.kind != NodeKind::Not)
    node.operand = field(edit, kOwn);
  if (row.kind == NodeKind::OperandEdge) node.memory = field(edit, kFirstPin);
  return node;
}

Node box(const Element& element, const Edit& edit) {
  Node node;
  node.kind = NodeKind::Box;
  node.element = &element;
  node.operand = field(edit, kOwn);
  node.arguments = edit.arguments;
  node.pins.resize(element.pins.size());
  for (std::size_t i = 0; i < node.pins.size(); ++i)
    if (element.pins[i].kind == PinKind::ValueIn || element.pins[i].kind == PinKind::ValueOut)
      node.pins[i].operand = field(edit, kFirstPin + static_cast<int>(i));
  return node;
}

// Blocks and labels are called as their author likes.
bool namesBlockOrLabel(const Element& element) {
  const auto free = [](const Item& item) {
    return item.op == Op::OPEN || item.op == Op::UC || item.op == Op::CC || item.op == Op::SPA ||
           item.op == Op::SPB || item.op == Op::SPBN;
  };
  return element.row.kind == ElementClass::Call ||
         std::any_of(element.items.begin(), element.items.end(), free);
}

}  // namespace

std::optional<Node> newNode(const Edit& edit, const Rules& rules) {
  for (const LeafRow& row : kLeaves)
    if (row.element == edit.element && (rules.extended || !row.extended)) return leaf(row, edit);
  const Element* element = rules.elements->find(edit.element);
  if (element == nullptr || isCoil(*element)) return std::nullopt;
  return box(*element, edit);
}

std::optional<Coil> newCoil(const Edit& edit, const Rules& rules) {
  const Element* element = rules.elements->find(edit.element);
  if (element == nullptr || !isCoil(*element)) return std::nullopt;
  Coil coil;
  coil.element = element;
  coil.operand = field(edit, kOwn);
  for (std::size_t i = 0; i < element->pins.size(); ++i)
    coil.values.push_back(field(edit, kFirstPin + static_cast<int>(i)));
  return coil;
}

std::optional<NodeKind> gateKind(std::string_view element, const Rules& rules) {
  for (const GateRow& row : kGates)
    if (row.element == element && (rules.extended || row.kind != NodeKind::Xor)) return row.kind;
  return std::nullopt;
}

bool fitsContact(const Operand& operand) {
  return operand.kind == OperandKind::None || operand.kind == OperandKind::Bit ||
         operand.kind == OperandKind::Wire || operand.kind == OperandKind::Number ||
         operand.kind == OperandKind::Status;
}

bool fitsValue(const Operand& operand) {
  return operand.kind == OperandKind::None || operand.kind == OperandKind::Value ||
         operand.kind == OperandKind::Number;
}

bool fitsOwn(const Element& element, const Operand& operand) {
  if (!namesBlockOrLabel(element)) return fitsContact(operand);
  return fitsValue(operand) || operand.kind == OperandKind::Label;
}

bool fits(const Node& made) {
  if (!fitsContact(made.memory)) return false;
  if (made.kind != NodeKind::Box) return fitsContact(made.operand);
  return fitsOwn(*made.element, made.operand) &&
         std::all_of(made.pins.begin(), made.pins.end(),
                     [](const Pin& pin) { return fitsValue(pin.operand); });
}

bool fits(const Coil& made) {
  return fitsOwn(*made.element, made.operand) &&
         std::all_of(made.values.begin(), made.values.end(), fitsValue);
}

}  // namespace merker::graph
