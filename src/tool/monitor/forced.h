// What is forced, and what may be forced beside it.
#pragma once

#include <optional>
#include <vector>

#include "address/reference.h"
#include "base/problem.h"

namespace merker::monitor {

struct Forced {
  address::Reference operand;
  std::uint32_t value = 0;
};

bool samePlace(const address::Reference& a, const address::Reference& b);
bool overlap(const address::Reference& a, const address::Reference& b);

// P1219: an operand that shares bits with a forced one; the same operand again takes its new value.
std::optional<Problem> checkForce(const std::vector<Forced>& list,
                                  const address::Reference& operand);

}  // namespace merker::monitor
