// The right side of a line of [campaign.vary]: a value, a list of values, a range, or how values
// are drawn.
#pragma once

#include "campaign/definition.h"
#include "project/table.h"

namespace merker::campaign {

// False, and a problem, if it is none of them.
bool readValues(const project::Table& table, const std::string& key, Parameter& parameter);

}  // namespace merker::campaign
