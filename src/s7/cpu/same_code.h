// Whether the translation of a block does for another one.
#pragma once

#include "block/block.h"

namespace merker::cpu {

inline bool sameCode(const block::Block& a, const block::Block& b) {
  return a.code == b.code && a.localBytes == b.localBytes;
}

}  // namespace merker::cpu
