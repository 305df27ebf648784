// Files and standard input as bytes, no more than a source may have (P0103).
#pragma once

#include <string>

#include "base/result.h"

namespace merker::app {

Result<std::string> readBytes(const std::string& path);
Result<std::string> readStandardInput();
// False, and the reason on standard error, if it cannot be written.
bool writeText(const std::string& path, const std::string& text);

}  // namespace merker::app
