// The variables of an S7 endpoint of Node-RED: "address;name", one a line.
#pragma once

#include "tags/format.h"

namespace merker::tags {

Output nodeRed(const std::vector<Tag>& tags, const FormatOptions& options);

}  // namespace merker::tags
