#include "tags/node_red.h"

#include <fmt/format.h>

#include "tags/address.h"
#include "tags/names.h"

namespace merker::tags {

// The import splits lines at ";" and at tabs.
Output nodeRed(const std::vector<Tag>& tags, const FormatOptions&) {
  Output output;
  UniqueNames unique;
  for (const Tag& tag : tags) {
    const auto place = address(tag, kNodeRed);
    if (!place) {
      output.left.push_back(fullName(tag));
      continue;
    }
    const auto allowed = [](char c) { return c != ';' && c != '\t'; };
    output.text += fmt::format("{};{}\r\n", *place, unique(cleaned(fullName(tag), allowed)));
  }
  return output;
}

}  // namespace merker::tags
