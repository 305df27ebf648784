// The code page that the texts of a program are written in, and characters that it does not have.
#pragma once

#include <string>
#include <vector>

#include "project/project.h"

namespace merker::exporting {

// The page of Windows that has most characters of sources and symbols; 1252 where it has all.
unsigned pageOf(const project::Project& project);

// A warning for each character of sources and symbols that the page does not have, with its first
// place: "file:3:7: warning: …".
std::vector<std::string> missingIn(unsigned page, const project::Project& project);

}  // namespace merker::exporting
