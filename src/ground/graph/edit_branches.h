// Branches while a network is edited: the temporary bits between rungs.
#pragma once

#include "graph/locate.h"

namespace merker::graph {

// The temporary bit of a branch behind the nodes, which is made if there is none yet.
Operand branchBehind(Network& network, const Location& at);
Node wireContact(const Operand& wire);
// Logic of a parameter of a CALL, made if there is none yet; null: it takes none.
std::vector<Node>* logicOfArgument(const Network& network, Node& call, std::size_t argument);
// Number of the first rung behind this one, and behind those that branch off from it.
std::size_t behindBranches(const Network& network, std::size_t rung);
// The same for those only that branch off at the wire or behind it.
std::size_t behindBranch(const Network& network, std::size_t rung, const Operand& wire);
// With wires that the network does not have. What its contacts read without writing it is missing.
Network withFreshWires(Network fragment, const Network& network);
// Without branches.
Network separated(Network fragment);
// Rungs whose branch is gone go too; so do branches from which no rung goes out any more. `before`:
// the network as it was.
void tidyBranches(Network& network, const Network& before);

}  // namespace merker::graph
