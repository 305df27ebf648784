// The BLD that mark what statements alone do not say.
#pragma once

#include <cstdint>

namespace merker::graph::bld {

constexpr std::uint32_t kOperandEdge = 100;  // U op; BLD 100; FP m: the edge of an operand
constexpr std::uint32_t kStraight = 102;     // from a branch straight to the coil
constexpr std::uint32_t kParameter = 103;    // the logic before it is given to a BOOL parameter

}  // namespace merker::graph::bld
