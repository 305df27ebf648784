// Labels of networks that come into a block from elsewhere.
#pragma once

#include "networks/source_networks.h"

namespace merker::networks {

// The text in which the networks [from, to) of the block have labels that no other has; their own
// jumps follow.
std::string withFreeLabels(const source::SourceFile& file, const Block& block, std::size_t from,
                           std::size_t to);

}  // namespace merker::networks
