#include "graph/edit_operand.h"

#include <algorithm>

#include "graph/complete.h"
#include "graph/edit_branches.h"
#include "graph/new_element.h"
#include "graph/simplify.h"

namespace merker::graph {
namespace {

using Refused = std::optional<EditProblem>;

Refused set(Operand& field, const Operand& operand, bool fits) {
  if (!fits) return EditProblem::NoOperand;
  field = operand;
  return std::nullopt;
}

Refused setOnCoil(Coil& coil, int pin, const Operand& operand) {
  const auto value = static_cast<std::size_t>(pin - kFirstPin);
  if (pin == kOwn) return set(coil.operand, operand, fitsOwn(*coil.element, operand));
  if (pin < kFirstPin || value >= coil.values.size()) return EditProblem::NoPin;
  return set(coil.values[value], operand, fitsValue(operand));
}

Refused setOnLeaf(Node& node, int pin, const Operand& operand) {
  const bool memory = node.kind == NodeKind::Edge
                          ? pin == kOwn || pin == kFirstPin
                          : node.kind == NodeKind::OperandEdge && pin == kFirstPin;
  if (memory) return set(node.memory, operand, fitsContact(operand));
  const bool has = node.kind == NodeKind::Contact || node.kind == NodeKind::OperandEdge ||
                   node.kind == NodeKind::Connector;
  if (!has || pin != kOwn) return EditProblem::NoPin;
  return set(node.operand, operand, fitsContact(operand));
}

// A contact, if nothing else is at the pin.
Refused setLogic(std::vector<Node>& logic, const Operand& operand) {
  const bool free = logic.empty() || logic.front().kind == NodeKind::Contact;
  if (!free || !fitsContact(operand)) return EditProblem::NoOperand;
  if (operand.kind == OperandKind::None) {
    logic.clear();
    return std::nullopt;
  }
  if (logic.empty()) logic.push_back(missingContact());
  logic.front().operand = operand;
  return std::nullopt;
}

// Given as it is, as STEP 7 stores it: "a := E 0.5". Where a contact is drawn, it gets the operand.
Refused setArgument(Node& call, std::size_t number, const Operand& operand) {
  Argument& argument = call.arguments[number];
  const bool contact = operand.kind == OperandKind::Bit || operand.kind == OperandKind::Wire;
  std::vector<Node>* logic = logicOfPin(call, kFirstPin + static_cast<int>(number));
  if (contact && logic != nullptr && !logic->empty()) return setLogic(*logic, operand);
  if (logic != nullptr) logic->clear();
  dropEmptyParameters(call);
  argument.text = operand.text;
  return std::nullopt;
}

// Parameters that the other block has, too, keep what is given to them.
void takeParameters(Node& call, std::vector<Argument> others) {
  for (Argument& other : others)
    for (Argument& old : call.arguments)
      if (old.name == other.name && (old.wire < 0 || other.bit)) {
        other.text = std::move(old.text);
        other.wire = old.wire;
      }
  call.arguments = std::move(others);
  std::erase_if(call.parameters, [&call](const Pin& parameter) {
    return std::none_of(
        call.arguments.begin(), call.arguments.end(),
        [&parameter](const Argument& one) { return one.wire == parameter.operand.number; });
  });
}

Refused setOnBox(Node& box, const Edit& edit, const Operand& operand) {
  const int pin = edit.at.pin;
  if (pin == kOwn && !edit.arguments.empty()) takeParameters(box, edit.arguments);
  if (pin == kOwn) return set(box.operand, operand, fitsOwn(*box.element, operand));
  if (pin == kEnable) return setLogic(box.enable, operand);
  const bool call = box.element->row.kind == ElementClass::Call;
  const auto number = static_cast<std::size_t>(pin - kFirstPin);
  if (pin < kFirstPin || number >= (call ? box.arguments.size() : box.pins.size()))
    return EditProblem::NoPin;
  if (call) return setArgument(box, number, operand);
  const PinKind kind = box.element->pins[number].kind;
  if (kind == PinKind::Output) return EditProblem::NoPin;
  if (kind == PinKind::Logic) return setLogic(box.pins[number].logic, operand);
  return set(box.pins[number].operand, operand, fitsValue(operand));
}

}  // namespace

std::vector<Node>* logicOfPin(Node& box, int pin) {
  if (pin == kEnable) return &box.enable;
  const auto number = static_cast<std::size_t>(pin - kFirstPin);
  if (pin < kFirstPin) return nullptr;
  if (box.element->row.kind != ElementClass::Call)
    return number < box.pins.size() ? &box.pins[number].logic : nullptr;
  if (number >= box.arguments.size()) return nullptr;
  for (Pin& parameter : box.parameters)
    if (box.arguments[number].wire == parameter.operand.number) return &parameter.logic;
  return nullptr;
}

Refused setOperand(const Location& at, const Edit& edit) {
  const Operand operand = edit.operands.empty() ? Operand{} : edit.operands.front();
  if (at.coil != nullptr) return setOnCoil(*at.coil, edit.at.pin, operand);
  if (at.count > 1) return EditProblem::NoPin;
  Node& node = at.node();
  return node.kind == NodeKind::Box ? setOnBox(node, edit, operand)
                                    : setOnLeaf(node, edit.at.pin, operand);
}

}  // namespace merker::graph
