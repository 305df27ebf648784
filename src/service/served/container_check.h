// A block that a client hands over: whether its container is one, and what it holds.
#pragma once

#include "block/block.h"
#include "s7comm/block_store.h"

namespace merker::served {

struct CheckedBlock {
  s7comm::Error error = s7comm::Error::None;
  block::Block block{};  // if there is none
};

BlockId idOf(const s7comm::BlockName& name);
// In any thread. The block must be the one that was announced.
CheckedBlock checkedBlock(const s7comm::BlockName& name, s7comm::Bytes container);

}  // namespace merker::served
