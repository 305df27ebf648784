// Tags for "Import CSV" of a device of Kepware.
#pragma once

#include "tags/format.h"

namespace merker::tags {

Output kepware(const std::vector<Tag>& tags, const FormatOptions& options);

}  // namespace merker::tags
