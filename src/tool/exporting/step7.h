// Files of STEP 7.
#pragma once

#include "exporting/format.h"

namespace merker::exporting {

// All blocks as one AWL source; beside it, if there are symbols, their table as .sdf, and blocks
// without source as .wld.
Output writeAwl(const compilation::Build& build, const std::string& path, const Options& options);
// Containers one behind the other.
Output writeWld(const compilation::Build& build, const std::string& path, const Options& options);
// By the extension: .sdf, .asc, .dif, .seq.
Output writeSymbolTable(const compilation::Build& build, const std::string& path,
                        const Options& options);

}  // namespace merker::exporting
