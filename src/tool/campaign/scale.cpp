#include "campaign/scale.h"

#include <fmt/format.h>

#include <algorithm>

namespace merker::campaign {
namespace {

bool before(const Value& a, const Value& b) {
  return a.number && b.number ? *a.number < *b.number : a.text < b.text;
}

// In place of many numbers.
void divide(Scale& scale) {
  const double low = *scale.places.front().number, high = *scale.places.back().number;
  scale.low = low;
  scale.part = (high - low) / static_cast<double>(kParts);
  scale.places.clear();
  for (std::size_t i = 0; i < kParts; ++i) {
    const double middle = low + (static_cast<double>(i) + 0.5) * scale.part;
    scale.places.push_back({fmt::format("{:.3g}", middle), middle});
  }
}

}  // namespace

std::size_t Scale::placeOf(const Value& value) const {
  if (part > 0) {
    const auto place = static_cast<std::size_t>((value.number.value_or(low) - low) / part);
    return std::min(place, places.size() - 1);
  }
  return static_cast<std::size_t>(std::ranges::find(places, value) - places.begin());
}

Scale scaleOf(const ResultTable& table, std::size_t parameter) {
  Scale scale{table.parameters[parameter], {}, true, 0, 0};
  for (const ResultTable::Row& row : table.rows) {
    scale.places.push_back(row.parameters[parameter]);
    scale.numbers &= scale.places.back().number.has_value();
  }
  std::ranges::sort(scale.places, before);
  scale.places.erase(std::unique(scale.places.begin(), scale.places.end()), scale.places.end());
  if (scale.numbers && scale.places.size() > kMostPlaces) divide(scale);
  return scale;
}

}  // namespace merker::campaign
