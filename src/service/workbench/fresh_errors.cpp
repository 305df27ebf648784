#include "workbench/fresh_errors.h"

#include <set>
#include <utility>

namespace merker::workbench {

Problems freshErrors(const Problems& before, const Problems& after) {
  std::set<std::pair<ProblemCode, std::string_view>> known;
  for (const Problem& problem : before.list()) known.emplace(problem.code, problem.message);
  Problems fresh;
  for (const Problem& problem : after.list())
    if (problem.severity() == Severity::Error && !known.contains({problem.code, problem.message}))
      fresh.add(problem);
  return fresh;
}

}  // namespace merker::workbench
