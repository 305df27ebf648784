// Whether a term of a check (//=) holds.
#pragma once

#include <cmath>

#include "check/check.h"

namespace merker::block {

// Bits count as unsigned numbers; ~= compares what `toReal` makes of them, with the relative
// tolerance of the command line contract.
template <typename ToReal>
bool holds(std::uint32_t a, Relation relation, std::uint32_t b, ToReal toReal) {
  constexpr double kTolerance = 1e-6;
  switch (relation) {
    case Relation::Equal:
      return a == b;
    case Relation::NotEqual:
      return a != b;
    case Relation::Less:
      return a < b;
    case Relation::LessEqual:
      return a <= b;
    case Relation::Greater:
      return a > b;
    case Relation::GreaterEqual:
      return a >= b;
    case Relation::About: {
      const double x = toReal(a), y = toReal(b);
      return std::fabs(x - y) <= kTolerance * std::fmax(std::fabs(x), std::fabs(y));
    }
  }
  return false;
}

}  // namespace merker::block
