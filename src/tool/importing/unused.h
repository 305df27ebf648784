// What lies in or beside projects of STEP 7 and does not come with them.
#pragma once

#include <vector>

#include "archive/tree.h"
#include "importing/report.h"
#include "s7p/catalogue.h"

namespace merker::importing {

// Sources that no program names, and other files that an import on their own would take.
void reportUnused(const archive::Tree& tree, const std::vector<s7p::Project>& projects,
                  Report& report);

}  // namespace merker::importing
