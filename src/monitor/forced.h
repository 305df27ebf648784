// What is forced, and what may be forced beside it.
#pragma once

#include <optional>
#include <vector>

#include "base/problem.h"
#include "mc7/reference.h"

namespace merker::monitor {

struct Forced {
  mc7::Reference operand;
  std::uint32_t value = 0;
};

bool samePlace(const mc7::Reference& a, const mc7::Reference& b);
bool overlap(const mc7::Reference& a, const mc7::Reference& b);

// P1219: an operand that shares bits with a forced one; the same operand again takes its new value.
std::optional<Problem> checkForce(const std::vector<Forced>& list, const mc7::Reference& operand);

}  // namespace merker::monitor
