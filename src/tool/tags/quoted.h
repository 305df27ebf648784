// Fields of CSV files.
#pragma once

#include <string>
#include <string_view>

namespace merker::tags {

// A field as RFC 4180 has it: in quotes, quotes doubled.
std::string inQuotes(std::string_view text);
// The same without quotes where none are needed.
std::string field(std::string_view text);

}  // namespace merker::tags
