// What loose files hold: sources, symbol tables, block containers, an exported station.
#pragma once

#include "archive/tree.h"
#include "importing/material.h"
#include "importing/report.h"

namespace merker::importing {

// All files of the tree `source` that are known. A listing of STEP 5 alone brings the symbols that
// lie beside it on the disk.
// `page`: of texts that are not Unicode; 0: by their content.
Material materialOf(const archive::Tree& tree, const std::string& source, unsigned page,
                    Report& report);

}  // namespace merker::importing
