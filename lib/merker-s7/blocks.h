// Blocks of the CPU: fetched, handed over, deleted; and what is done with the CPU as a whole.
#pragma once

#include <string>
#include <string_view>

#include "connection.h"

namespace merker::s7client {

struct BlockNumber {
  int type = 0, number = 0;
};

bool isBlock(const BlockNumber& block);
// "0A00001P"
std::string blockName(const BlockNumber& block, char files);
// The container of a block (docs/formats/block.md). 0, or an error of merker_s7.h, as all of them.
int upload(Connection& connection, const BlockNumber& block, s7comm::Bytes& container);
// Under this number, or that of the container if it is negative; it is active then.
int download(Connection& connection, int number, s7comm::Bytes container);
int removeBlock(Connection& connection, const BlockNumber& block);
// A named service of the CPU, and stop.
int callService(Connection& connection, std::string_view name, std::string_view argument,
                int refused);
int stopPlc(Connection& connection);

}  // namespace merker::s7client
