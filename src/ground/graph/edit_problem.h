// Why an edit cannot be done.
#pragma once

#include <cstdint>
#include <string_view>

#include "graph/language.h"

namespace merker::graph {

enum class EditProblem : std::uint8_t {
#define EDIT_PROBLEM(id, english, german) id,
#include "graph/edit_problems.inc"
#undef EDIT_PROBLEM
};

std::string_view text(EditProblem problem, Language language);

}  // namespace merker::graph
