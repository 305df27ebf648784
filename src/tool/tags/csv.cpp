#include "tags/csv.h"

#include <fmt/format.h>

#include "tags/address.h"
#include "tags/quoted.h"

namespace merker::tags {
namespace {

std::string_view access(const Tag& tag) { return !tag.readable ? "W" : tag.writable ? "RW" : "R"; }

std::string typeName(const Tag& tag) {
  return tag.type == TypeCode::String ? fmt::format("STRING[{}]", tag.length)
                                      : std::string(merker::name(tag.type));
}

}  // namespace

Output csv(const std::vector<Tag>& tags, const FormatOptions& options) {
  Output output{"name,address,type,access,comment\n", {}};
  for (const Tag& tag : tags)
    output.text +=
        fmt::format("{},{},{},{},{}\n", field(fullName(tag)), step7Address(tag, options.mnemonics),
                    typeName(tag), access(tag), field(tag.comment));
  return output;
}

}  // namespace merker::tags
