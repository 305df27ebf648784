// New elements, named as the editor names them.
#pragma once

#include <optional>

#include "graph/edit.h"

namespace merker::graph {

// A node that is no gate; nothing if the family has none of this name. Its operands are in its
// fields.
std::optional<Node> newNode(const Edit& edit, const Rules& rules);
std::optional<Coil> newCoil(const Edit& edit, const Rules& rules);
// AND, OR, XOR.
std::optional<NodeKind> gateKind(std::string_view element, const Rules& rules);

// Whether the operand can stand at a contact, with L or T, above a box or coil of the element.
bool fitsContact(const Operand& operand);
bool fitsValue(const Operand& operand);
bool fitsOwn(const Element& element, const Operand& operand);
// Whether what it was made with can stand in its fields.
bool fits(const Node& made);
bool fits(const Coil& made);

}  // namespace merker::graph
