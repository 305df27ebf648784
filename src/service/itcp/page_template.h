// A page with places for values, in the notation that Siemens' later web servers have: :="Level":
// and
// :=MW100: (SIMATIC S7-1500, Web server, "AWP commands: reading PLC tags").
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "itcp/escape.h"

namespace merker::itcp {

// What a place shows: a value, or why there is none.
struct PageValue {
  bool there = false;
  std::string text;
};

struct PageTemplate {
  static constexpr std::size_t kMostNames = 500, kLongestName = 200;

  std::vector<std::string_view> texts;  // one more than names; of the page, which outlives them
  std::vector<std::string> names;       // "\"Level\"", "MW100"
};

// What is no place stays text: a name is closed in its line, and shorter than a limit.
PageTemplate split(std::string_view page);
// A value for each name. In JSON one that is not there is null.
std::string fill(const PageTemplate& page, const std::vector<PageValue>& values, Escape how);

}  // namespace merker::itcp
