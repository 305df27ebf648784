// Tags of Ignition in folders, for a device that is named like the PLC (JSON).
#pragma once

#include "tags/format.h"

namespace merker::tags {

Output ignition(const std::vector<Tag>& tags, const FormatOptions& options);

}  // namespace merker::tags
