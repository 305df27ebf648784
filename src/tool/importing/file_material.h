// What loose files hold: sources, symbol tables, block containers, an exported station.
#pragma once

#include "archive/tree.h"
#include "importing/material.h"
#include "importing/report.h"

namespace merker::importing {

// All files of the tree that are known; the others are left out without a word.
// `page`: of texts that are not Unicode; 0: by their content.
Material materialOf(const archive::Tree& tree, const std::string& name, unsigned page,
                    Report& report);

}  // namespace merker::importing
