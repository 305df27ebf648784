// A file of the page, as it is embedded in the program.
#pragma once

#include <string_view>

namespace merker::hmi {

struct Asset {
  std::string_view path;  // "/index.html"
  std::string_view type;  // "text/html; charset=utf-8"
  std::string_view tag;   // ETag without quotation marks
  std::string_view bytes;
  std::string_view packed{};  // the same with gzip; empty: it becomes no smaller
};

}  // namespace merker::hmi
