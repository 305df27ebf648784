// Pages in the folder of the user.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "itcp/escape.h"

namespace merker::itcp {

struct PageFile {
  static constexpr std::size_t kLargest = 1 << 20;  // bytes

  std::string_view type;  // for the browser
  Escape escape = Escape::None;
  std::string bytes{};
};

// "/a%20b/?x=1" → "a b/index.html". Nothing: it leads out of the folder, to a hidden file, or is no
// path.
std::optional<std::string> pathOf(std::string_view target);
// Nothing: there is no such file, it lies somewhere else, or is too large. An empty folder has
// none.
std::optional<PageFile> pageFile(const std::string& folder, const std::string& path);

}  // namespace merker::itcp
