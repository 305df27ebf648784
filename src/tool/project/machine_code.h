// Container files (*.mc7) of a project.
#pragma once

#include "project/project.h"

namespace merker::project {

bool isMachineCode(std::string_view path);
// Adds the blocks of the file; one or several containers, one behind the other. SDBs are left out.
void readMachineCode(Project& project, const std::string& path);

}  // namespace merker::project
