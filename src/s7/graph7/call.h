// What the box of a CALL shows: the block that is called and its parameters.
#pragma once

#include "awl/statements.h"
#include "graph/statement.h"
#include "mc7/listing.h"

namespace merker::graph7 {

void describeCall(const mc7::Listing& listing, std::size_t at, std::size_t count,
                  const awl::Names& names, const awl::Blocks& blocks, Mnemonics mnemonics,
                  graph::Statement& statement);

}  // namespace merker::graph7
