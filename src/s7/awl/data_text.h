// The actual values of a data block as assignments.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "block/block.h"

namespace merker::awl {

// "a.b[2] := 5;" for each element whose value is not the one that `declared` has there. Types that
// have no assignment (POINTER, ANY) are left out.
std::string assignments(const block::Block& declared, std::span<const std::uint8_t> actual);

}  // namespace merker::awl
