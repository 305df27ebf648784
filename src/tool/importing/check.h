// What `merker check` says about the project that an import made or added to.
#pragma once

#include <stop_token>
#include <string>

#include "importing/report.h"

namespace merker::importing {

// `path`: of the project as `merker check` gets it. Nothing is said if it is stopped.
void reportCheck(const std::string& path, const std::stop_token& stop, Report& report);

}  // namespace merker::importing
