#include "graph/edit_problem.h"

#include <cstddef>

namespace merker::graph {
namespace {

struct Row {
  std::string_view english, german;
};
constexpr Row kRows[] = {
#define EDIT_PROBLEM(id, english, german) {english, german},
#include "graph/edit_problems.inc"
#undef EDIT_PROBLEM
};

}  // namespace

std::string_view text(EditProblem problem, Language language) {
  const Row& row = kRows[static_cast<std::size_t>(problem)];
  return language == Language::German ? row.german : row.english;
}

}  // namespace merker::graph
