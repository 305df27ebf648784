// The program structure (S7-EDIT-22) as rows of an answer.
#pragma once

#include "compilation/build.h"
#include "workbench/json.h"

namespace merker::workbench {

// Of a program that compiled.
Json structureRows(const compilation::Build& build);

}  // namespace merker::workbench
