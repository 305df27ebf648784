// One block of code or data as bytes, and back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "mc5/block.h"
#include "s5d/file.h"

namespace merker::s5d {

// The block without comments, formats and names of labels; what is wrong with it otherwise.
struct BlockOrReason {
  std::optional<mc5::Block> block;
  std::string reason;
};
BlockOrReason readBlock(const Record& record, Encoding codePage);

std::vector<std::uint8_t> writeBlock(const mc5::Block& block, Encoding codePage);

}  // namespace merker::s5d
