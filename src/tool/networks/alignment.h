// Which statements of a network stay when it is written anew.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/statement.h"

namespace merker::networks {

// The same statement, wherever a jump of it leads.
bool sameStatement(const graph::Statement& a, const graph::Statement& b);

// For each new statement the number of an old one, or -1. Both lists ascend.
struct Alignment {
  std::vector<std::int32_t> same;     // it stays
  std::vector<std::int32_t> instead;  // it takes the place of this one
  std::int32_t origin(std::size_t now) const { return same[now] >= 0 ? same[now] : instead[now]; }
};

Alignment align(const graph::Statements& old, const graph::Statements& now);

}  // namespace merker::networks
