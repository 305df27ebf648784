// What `merker check` says about the project that an import made or added to.
#pragma once

#include <string>

#include "importing/report.h"

namespace merker::importing {

// `path`: of the project as `merker check` gets it.
void reportCheck(const std::string& path, Report& report);

}  // namespace merker::importing
