#include "importing/check.h"

#include "compilation/build.h"

namespace merker::importing {

void reportCheck(const std::string& path, Report& report) {
  compilation::Build build = compilation::build(project::load(path, ""), false);
  if (build.ok()) return;
  for (const Problem& problem : build.problems.list())
    if (problem.severity() == Severity::Error)
      return report.add(
          Note::StillProblems, build.problems.count(Severity::Error),
          fmt::format("{}:{}: {}", problem.position.file, problem.position.line, problem.message),
          build.problems.count(Severity::Error) == 1 ? "error" : "errors");
}

}  // namespace merker::importing
