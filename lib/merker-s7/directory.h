// What blocks a CPU has, and what their heads say.
#pragma once

#include <vector>

#include "blocks.h"
#include "merker_s7.h"

namespace merker::s7client {

int listBlocks(Connection& connection, TS7BlocksList& counts);
int listBlocksOfType(Connection& connection, int type, std::vector<std::uint16_t>& numbers);
int blockInfo(Connection& connection, const BlockNumber& block, TS7BlockInfo& info);
// The same of a container. False: it is none.
bool readInfo(s7comm::View container, TS7BlockInfo& info);

}  // namespace merker::s7client
