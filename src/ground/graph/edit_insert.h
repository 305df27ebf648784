// Puts elements into a network. Each function gives the problem if they cannot be there; then the
// network is spoilt. `at`: nothing for the end of the network.
#pragma once

#include <optional>

#include "graph/edit.h"
#include "graph/locate.h"

namespace merker::graph {

// What is changed, and how.
struct Editing {
  Network& network;
  const Edit& edit;  // its `place`, and the pin that is meant
  const Rules& rules;
};

// `edit.element`, whatever it is.
std::optional<EditProblem> insert(const Editing& editing, const std::optional<Location>& at);
// A node that is no gate of FUP.
std::optional<EditProblem> insertNode(const Editing& editing, const std::optional<Location>& at,
                                      Node node);
// AND, OR, XOR of what is there and one more input.
std::optional<EditProblem> insertGate(const Editing& editing, const std::optional<Location>& at,
                                      NodeKind kind);
std::optional<EditProblem> insertCoil(const Editing& editing, const std::optional<Location>& at,
                                      Coil coil);
// A rung of its own from a place within another one.
std::optional<EditProblem> insertBranch(const Editing& editing, const Location& at,
                                        std::optional<Node> node, std::optional<Coil> coil);

// The logic that is at the pin of a box, or can be: then it is made.
std::optional<EditProblem> logicAtPin(const Editing& editing, const Location& at,
                                      std::vector<Node>*& logic);
// It waits for its coil; behind a box none is needed.
bool isUnfinished(const Rung& rung);
std::size_t numberOf(const Network& network, const Rung& rung);

}  // namespace merker::graph
