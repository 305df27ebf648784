#include "graph/edit_problem.h"

#include <cstddef>

namespace merker::graph {
namespace {

constexpr Sentence kProblems[] = {
#define EDIT_PROBLEM(id, english, german) {english, german},
#include "graph/edit_problems.inc"
#undef EDIT_PROBLEM
};

}  // namespace

std::string_view text(EditProblem problem, Language language) {
  return kProblems[static_cast<std::size_t>(problem)].in(language);
}

}  // namespace merker::graph
