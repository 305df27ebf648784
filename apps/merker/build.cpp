#include "build.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "command.h"

namespace merker::app {

int exitCode(const Build& build) {
  if (build.project.unreadable) return kUnreadable;
  return build.ok() ? kGood : kProblems;
}

int refuseListing(std::string_view command) {
  std::cerr << "merker " << command
            << ": this command supports SIMATIC S7 programs only; for a SINUMERIK "
            << "use check, run, test, list, xref, diag, debug, workbench, export or bench\n";
  return kUsage;
}

int report(const Build& build, bool json) {
  printProblems(build.problems, build.files());
  if (json) print({{"problems", toJson(build.problems)}});
  return exitCode(build);
}

}  // namespace merker::app
