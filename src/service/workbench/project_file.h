// Files of the project that the simulator writes.
#pragma once

#include "workbench/fields.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

// The field "path" with this ending: no other file is overwritten by mistake.
std::string pathOf(const Fields& fields, std::string_view ending);
// Whole or not at all; P1312 if it is there and is not to be replaced.
std::optional<Problem> putFile(const ProjectFolder& folder, const std::string& path,
                               std::string_view bytes, bool replace);
// What came of it, and the folder afterwards.
struct Put {
  std::optional<Problem> problem;
  Listing files;
};

}  // namespace merker::workbench
