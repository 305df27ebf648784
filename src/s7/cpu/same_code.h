// Whether a block that is loaded anew is the one before: its translation does, its values stay.
#pragma once

#include "block/block.h"

namespace merker::cpu {

inline bool sameCode(const block::Block& a, const block::Block& b) {
  return a.code == b.code && a.localBytes == b.localBytes;
}

inline bool sameData(const block::Block& a, const block::Block& b) {
  const block::Attributes &x = a.attributes, &y = b.attributes;
  return a.actualData == b.actualData && a.initialData == b.initialData &&
         x.readOnly == y.readOnly && x.unlinked == y.unlinked && x.nonRetain == y.nonRetain;
}

}  // namespace merker::cpu
