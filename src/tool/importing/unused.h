// What lies in or beside projects and does not come with them.
#pragma once

#include <vector>

#include "archive/tree.h"
#include "importing/merker_project.h"
#include "importing/report.h"
#include "importing/step5_material.h"
#include "s7p/catalogue.h"

namespace merker::importing {

// Sources that no program names, files that an import on their own would take, and those that
// nobody knows. Without a project all files are looked at on their own.
void reportUnused(const archive::Tree& tree, const std::vector<s7p::Project>& projects,
                  const std::vector<Step5Program>& step5, const std::vector<MerkerProject>& merker,
                  Report& report);

}  // namespace merker::importing
