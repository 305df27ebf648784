// A device of FUXA with its tags, as its export of connections writes them (JSON).
#pragma once

#include "tags/format.h"

namespace merker::tags {

Output fuxa(const std::vector<Tag>& tags, const FormatOptions& options);

}  // namespace merker::tags
