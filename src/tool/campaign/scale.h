// The values of a parameter as places along an axis of a picture: one for each value, or, of many
// numbers, one for each of equal parts between the smallest and the largest.
#pragma once

#include <string>
#include <vector>

#include "campaign/table.h"

namespace merker::campaign {

struct Scale {
  std::string name;
  std::vector<Value> places;  // in rising order; of parts their middle
  bool numbers = false;
  double low = 0, part = 0;  // of parts; 0: each value has a place

  std::size_t placeOf(const Value& value) const;
};

constexpr std::size_t kMostPlaces = 50, kParts = 20;

// Of a parameter of the table.
Scale scaleOf(const ResultTable& table, std::size_t parameter);

}  // namespace merker::campaign
