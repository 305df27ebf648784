// Characters that a code page of Windows does not have.
#pragma once

#include <string>
#include <vector>

#include "project/project.h"

namespace merker::exporting {

// A warning for each such character of sources and symbols, with its first place: "file:3:7:
// warning: …".
std::vector<std::string> missingInCp1252(const project::Project& project);

}  // namespace merker::exporting
