// The relations of checks and expectations, for any values that have an order.
#pragma once

#include <string_view>

#include "check/check.h"

namespace merker::simulator {

// ~=: equal in six digits.
bool about(double a, double b);

// ~= is for REAL and data of the NC alone, see about(), and never holds here.
template <typename T>
bool relates(const T& a, block::Relation relation, const T& b) {
  switch (relation) {
    case block::Relation::Equal:
      return a == b;
    case block::Relation::NotEqual:
      return a != b;
    case block::Relation::Less:
      return a < b;
    case block::Relation::LessEqual:
      return a <= b;
    case block::Relation::Greater:
      return a > b;
    case block::Relation::GreaterEqual:
      return a >= b;
    case block::Relation::About:
      return false;
  }
  return false;
}

std::string_view text(block::Relation relation);

struct RelationText {
  std::string_view text;
  block::Relation relation;
};
// The relation that the text begins with; null if it is none.
const RelationText* relationAt(std::string_view text);

}  // namespace merker::simulator
