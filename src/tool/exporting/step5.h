// Files of STEP 5.
#pragma once

#include "exporting/format.h"

namespace merker::exporting {

// The program; beside it, if it has symbols, xxxxxxZ0.SEQ.
Output writeS5d(const compilation::Build& build, const std::string& path, const Options& options);
// With symbols their list beside it, without which it does not compile.
Output writeListing(const compilation::Build& build, const std::string& path,
                    const Options& options);
Output writeAssignmentList(const compilation::Build& build, const std::string& path,
                           const Options& options);

}  // namespace merker::exporting
