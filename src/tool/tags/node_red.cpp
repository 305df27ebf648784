#include "tags/node_red.h"

#include <fmt/format.h>

#include "tags/address.h"
#include "tags/names.h"

namespace merker::tags {
namespace {

// Timers and counters: @st-one-io/nodes7 asks for them as data of another area, and loses all
// values of the group when it is refused.
bool readable(const Tag& tag) { return tag.area != TagArea::Timer && tag.area != TagArea::Counter; }

}  // namespace

// The import splits lines at ";" and at tabs.
Output nodeRed(const std::vector<Tag>& tags, const FormatOptions&) {
  Output output;
  UniqueNames unique;
  for (const Tag& tag : tags) {
    const auto place = address(tag, kNodeRed);
    if (!place || !readable(tag)) {
      output.left.push_back(fullName(tag));
      continue;
    }
    const auto allowed = [](char c) { return c != ';' && c != '\t'; };
    output.text += fmt::format("{};{}\r\n", *place, unique(cleaned(fullName(tag), allowed)));
  }
  return output;
}

}  // namespace merker::tags
