// The machine code of a block as regions of intermediate code.
#pragma once

#include <span>
#include <vector>

#include "catalogue/cpu_model.h"
#include "icode/region.h"
#include "mc7/listing.h"

namespace merker::translate {

// In the order of the code. Instructions that belong to no region have no translation; regions end
// in front of them. Every jump target that can be translated begins a region. `apart`: by
// instruction, those that stay with the interpreter; empty: none.
//
// A region in which the clock cannot reach the horizon is executed in one go; shorter ones lose
// less when an event is near. Brackets are never divided. In a loop a region goes on with the next
// turns as far as it may be long: they stand in it once more.
constexpr std::uint32_t kLongestRegion = 128;
std::vector<icode::Region> translate(const mc7::Listing& listing, const CpuModel& model,
                                     const std::vector<bool>& apart = {},
                                     std::uint32_t longest = kLongestRegion);

}  // namespace merker::translate
