#include "tags/kepware.h"

#include <fmt/format.h>

#include "tags/address.h"
#include "tags/names.h"
#include "tags/quoted.h"

namespace merker::tags {
namespace {

// Dots part groups; a name has no quotes and does not begin with an underscore.
std::string nameOf(const Tag& tag) {
  std::string text;
  for (const std::string& part : tag.path) {
    const auto allowed = [](char c) { return c != '.' && c != '"' && c != '[' && c != ']'; };
    std::string name = cleaned(part, allowed);
    if (name.starts_with('_')) name.insert(0, "x");
    text += (text.empty() ? "" : ".") + name;
  }
  return text;
}

constexpr int kScanMilliseconds = 100;  // Kepware's own default

}  // namespace

// The columns of its export; an empty one is the default of the server.
Output kepware(const std::vector<Tag>& tags, const FormatOptions&) {
  Output output{
      "Tag Name,Address,Data Type,Respect Data Type,Client Access,Scan Rate,Scaling,Raw Low,Raw "
      "High,Scaled Low,Scaled High,Scaled Data Type,Clamp Low,Clamp High,Eng. "
      "Units,Description\r\n",
      {}};
  UniqueNames unique;
  for (const Tag& tag : tags) {
    const auto place = address(tag, kKepware);
    if (!place) {
      output.left.push_back(fullName(tag));
      continue;
    }
    output.text +=
        fmt::format("{},{},{},1,{},{},,,,,,,,,,{}\r\n", inQuotes(unique(nameOf(tag))),
                    inQuotes(*place), kKepware.tagType(tag.type), tag.writable ? "R/W" : "RO",
                    kScanMilliseconds, inQuotes(tag.comment));
  }
  return output;
}

}  // namespace merker::tags
