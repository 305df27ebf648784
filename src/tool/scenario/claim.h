// What stands behind `expect`, cut into its parts: "LED RUN = on". Every text is a view into the
// file.
#pragma once

#include <string_view>

#include "check/check.h"

namespace merker::simulator {

struct Claim {
  std::string_view whole;    // without "for 5s", "within 5s" and "partner"
  std::string_view word;     // "LED"; empty: it speaks of an operand
  std::string_view subject;  // "RUN": between the word and the relation
  block::Relation relation = block::Relation::Equal;
  std::string_view value;  // "on"

  bool comparesEqual() const {
    return relation == block::Relation::Equal || relation == block::Relation::NotEqual;
  }
};

// Whether = or <> holds.
inline bool agrees(bool equal, block::Relation relation) {
  return equal == (relation == block::Relation::Equal);
}

}  // namespace merker::simulator
