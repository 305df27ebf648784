// The relations of checks (//=) and of expectations: their signs, and whether one holds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "check/check.h"

namespace merker::block {

struct RelationSign {
  std::string_view text;
  Relation relation;
};

// The relation that the text begins with; null if it is none.
inline const RelationSign* relationAt(std::string_view text) {
  // Two characters before one: <= before <.
  static constexpr std::array kSigns{
      RelationSign{"<>", Relation::NotEqual},     RelationSign{"<=", Relation::LessEqual},
      RelationSign{">=", Relation::GreaterEqual}, RelationSign{"~=", Relation::About},
      RelationSign{"==", Relation::Equal},        RelationSign{"=", Relation::Equal},
      RelationSign{"<", Relation::Less},          RelationSign{">", Relation::Greater}};
  for (const RelationSign& row : kSigns)
    if (text.starts_with(row.text)) return &row;
  return nullptr;
}

// For any values that have an order. ~= is for real numbers alone, see about(), and never holds
// here.
template <typename T>
constexpr bool relates(const T& a, Relation relation, const T& b) {
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
    case Relation::About:
      return false;
  }
  return false;
}

// ~=: equal within a relative tolerance (docs/formats/scenario.md, Comparisons).
inline bool about(double a, double b) {
  constexpr double kTolerance = 1e-6;
  return a == b || std::abs(a - b) <= kTolerance * std::max(std::abs(a), std::abs(b));
}

// A term of a check: bits count as unsigned numbers; ~= compares what `toReal` makes of them.
template <typename ToReal>
bool holds(std::uint32_t a, Relation relation, std::uint32_t b, ToReal toReal) {
  return relation == Relation::About ? about(toReal(a), toReal(b)) : relates(a, relation, b);
}

}  // namespace merker::block
