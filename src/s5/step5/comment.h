// Comments of a listing, kept for those who print it again.
#pragma once

#include <string_view>

#include "mc5/block.h"

namespace merker::step5 {

// "! lamp on" of the rest of a line, with a mark also where the source had none; empty if there is
// nothing behind the mark.
std::string commentText(std::string_view rest);

// `behind`: in the line of what stands at the word; else on a line before it.
void keepComment(mc5::Block& block, std::uint32_t word, bool behind, std::string_view rest);

}  // namespace merker::step5
