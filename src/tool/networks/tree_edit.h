// An edit of the tree of a network as one of its text.
#pragma once

#include "networks/source_edit.h"
#include "networks/text.h"

namespace merker::networks {

// The network has a tree; the operands are as its text has them.
Edited treeEdit(const source::SourceFile& file, Found& found, std::size_t network,
                const graph::Edit& edit, const Surroundings& around);

// As the statements of the block are written.
Style styleOf(const source::SourceFile& file, const Found& found, const Network& network);

}  // namespace merker::networks
