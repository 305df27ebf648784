// Tables of merker.toml whose keys are numbers: "155 = 2".
#pragma once

#include <algorithm>
#include <charconv>
#include <span>

#include "project/table.h"

namespace merker::project {

inline std::optional<unsigned> keyNumber(std::string_view key) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  return error == std::errc() && end == key.data() + key.size() ? std::optional(number)
                                                                : std::nullopt;
}

struct KeyRange {
  unsigned first, last;          // of the key
  std::int64_t lowest, highest;  // of the value
};

inline void unknownKey(const Table& table, const std::string& key, std::string_view possible) {
  table.problems().add(ProblemCode::P0703, table.placeOf(key), key, table.title(), possible);
}

// Calls `take(number, key, range)` for each key that lies in one of the ranges.
template <typename Take>
void eachKey(const Table& table, std::span<const KeyRange> ranges, std::string_view possible,
             Take take) {
  for (const std::string& key : table.keys()) {
    const auto number = keyNumber(key);
    const auto range = std::find_if(ranges.begin(), ranges.end(), [&](const KeyRange& r) {
      return number && *number >= r.first && *number <= r.last;
    });
    if (range == ranges.end())
      unknownKey(table, key, possible);
    else
      take(*number, key, *range);
  }
}

// The same for whole numbers: `take(number, value)`.
template <typename Take>
void eachNumber(const Table& table, std::span<const KeyRange> ranges, std::string_view possible,
                Take take) {
  eachKey(table, ranges, possible,
          [&](unsigned number, const std::string& key, const KeyRange& range) {
            if (const auto value = table.integer(key, range.lowest, range.highest))
              take(number, *value);
          });
}

}  // namespace merker::project
