// The keys of the sub-module 2.5 in merker.toml (POS-PARAM).
#pragma once

#include <string_view>
#include <vector>

#include "project/table.h"

namespace merker::project {

const std::vector<std::string_view>& axisKeys();

}  // namespace merker::project
