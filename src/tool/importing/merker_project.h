// Projects of Merker in a tree: what the workbench gives to download comes back as it was.
#pragma once

#include <string>
#include <vector>

#include "archive/tree.h"
#include "importing/output.h"
#include "importing/report.h"

namespace merker::importing {

struct MerkerProject {
  std::string name;    // of its folder, or of the source of the tree
  std::string folder;  // in the tree
};

// Folders with a merker.toml that lie in no other such folder.
std::vector<MerkerProject> merkerProjects(const archive::Tree& tree, const std::string& source);

// All its files but hidden ones, as they are.
void copyMerkerProject(const archive::Tree& tree, const MerkerProject& project, Output& output,
                       Report& report);

}  // namespace merker::importing
