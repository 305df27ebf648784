// A table for any tool: name, address, type, access, comment (RFC 4180).
#pragma once

#include "tags/format.h"

namespace merker::tags {

Output csv(const std::vector<Tag>& tags, const FormatOptions& options);

}  // namespace merker::tags
