// A project as the commands compile and report it.
#pragma once

#include "compilation/build.h"
#include "output.h"

namespace merker::app {

using compilation::Build;
using compilation::build;
using compilation::noteMissingOb1;
using compilation::requireOb1;
using compilation::requireWorkMemory;

int exitCode(const Build& build);  // of the problems
// Prints the problems; with `json` also as an object on standard output. The exit code.
int report(const Build& build, bool json);
// Tells that the command knows SIMATIC S7 programs only. The exit code.
int refuseListing(std::string_view command);

}  // namespace merker::app
