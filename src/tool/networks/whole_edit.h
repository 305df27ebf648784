// Edits that change more than one network of a block.
#pragma once

#include "networks/source_edit.h"
#include "networks/text.h"

namespace merker::networks {

// Lines that make one text of the other; `network` and `select` are the caller's.
TextEdit difference(const source::SourceFile& before, const source::SourceFile& after);

// The edit, and behind it the numbers that the networks have in their heads, if they had them in
// their order.
TextEdit withNumbers(const source::SourceFile& file, const Found& found, TextEdit edit,
                     const Surroundings& around);

// Where lines come that are to stand behind the network.
std::uint32_t behindNetwork(const source::SourceFile& file, const graph::SourceNetwork& network);
// A block that is still empty.
inline bool isReplaced(const graph::SourceNetwork& network) {
  return !network.headed && network.statements.empty();
}

}  // namespace merker::networks
