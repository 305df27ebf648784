// Changes a network as a user of the editor does: an element is put in, taken out, turned round.
// There are only trees; what an edit leaves can always be written as statements and read again.
#pragma once

#include <cstdint>
#include <span>

#include "base/result.h"
#include "graph/edit_problem.h"
#include "graph/network.h"
#include "graph/rules.h"
#include "graph/selection.h"

namespace merker::graph {

enum class Action : std::uint8_t {
  Insert,       // `element` at `place` of the node
  AddInput,     // one more contact at the end of the gate, of FUP, that the node is or is part of
  Negate,       // a contact; behind anything else a NOT is put in or taken out
  CloseBranch,  // the end of the branch in which the node stands goes one element further right
  SetOperand,   // the field `pin` gets operands[0]; of a CALL that leaves it out: None
  Delete,       // a node, a coil, what is at a pin (pin >= kFirstPin or kEnable)
  DeleteRung,   // the one of the node, with the branches that go out from it
  NewRung,  // below the rung of the node, or below all: a contact and a coil, both without operand
  Move,     // the element `from` to `place` of the node
  Paste     // `pasted` at `place` of the node; rungs with coils: below that of the node
};

// Where an element goes. Behind a coil, which ends its rung, is before it. A coil goes `Behind`
// another coil or the last node of a rung, or as `Branch` with a temporary bit behind any node.
enum class Place : std::uint8_t { Before, Behind, Parallel, Branch, AtPin };

// What is no row of a family's table.
namespace element {
constexpr std::string_view
    kContact = "CONTACT",
    kContactNot = "CONTACT_NOT", kNot = "NOT", kRisingEdge = "P",
    kFallingEdge = "N",                               // of the signal
    kRisingOperand = "POS", kFallingOperand = "NEG",  // of an operand
    kConnector = "CONNECTOR",
    // gates of FUP: around the node with one more input; with no node: a rung
    kAnd = "AND", kOr = "OR", kXor = "XOR";
}  // namespace element

struct Edit {
  Action action = Action::Insert;
  Selection at;  // the element that is meant; node -1: the end of the network
  Place place = Place::Behind;
  std::string element;              // Insert: one of the above, or the id of a row
  std::vector<Operand> operands;    // by field: kOwn, kFirstPin...; what is left out is missing
  std::vector<Argument> arguments;  // of a CALL box: Insert, SetOperand of its block
  Selection from = {};              // Move
  Network pasted = {};              // Paste
  bool ladder = false;              // a ladder must stay one: what only FUP can draw is refused
};

struct Edited {
  Network network;        // canonical, with the numbers of its statements
  Statements statements;  // what it is written as
  Selection
      select;  // what the user goes on with: the new element, or what stands beside a deleted one
};

// `network` as `read` gave it. `firstWire`: the first temporary bit that is free in the network.
Result<Edited, EditProblem> apply(const Network& network, const Edit& edit, const Rules& rules,
                                  std::uint32_t firstWire);

// The elements as a network of their own, each without what comes to it. `firstWire`: as of
// `apply`.
Result<Statements, EditProblem> copy(const Network& network, std::span<const Selection> elements,
                                     const Rules& rules, std::uint32_t firstWire);

// Whether a branch begins in the element: then it cannot be moved.
bool carriesBranch(const Network& network, const Selection& element);

}  // namespace merker::graph
