// What `merker tags` writes: one row for each kind of file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tags/tag.h"

namespace merker::tags {

struct FormatOptions {
  Mnemonics mnemonics = Mnemonics::German;  // of the addresses in `csv`
  std::string device = "PLC";               // name of the PLC in the other tool
  std::string address = "127.0.0.1";        // of the S7 server: FUXA
};

struct Output {
  std::string text;               // UTF-8
  std::vector<std::string> left;  // names of tags that the tool cannot have
};

struct Format {
  std::string_view name;  // of --format
  std::string_view what;
  Output (*write)(const std::vector<Tag>& tags, const FormatOptions& options);
};

std::span<const Format> formats();
const Format* findFormat(std::string_view name);  // null if there is none

}  // namespace merker::tags
