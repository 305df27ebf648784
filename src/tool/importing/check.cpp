#include "importing/check.h"

#include <algorithm>

#include "compilation/build.h"

namespace merker::importing {

void reportCheck(const std::string& path, const std::stop_token& stop, Report& report) {
  const compilation::Build build = compilation::build(project::load(path, "", {}, stop), false);
  if (build.ok() || stop.stop_requested()) return;
  const auto first = std::ranges::find(build.problems.list(), Severity::Error, &Problem::severity);
  const std::size_t count = build.problems.count(Severity::Error);
  report.add(Note::StillProblems, count,
             fmt::format("{}:{}: {}", first->position.file, first->position.line, first->message),
             count == 1 ? "error" : "errors");
  report.quotes(*first);
}

}  // namespace merker::importing
