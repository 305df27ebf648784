#include "base/problem.h"

#include <fmt/args.h>

#include <algorithm>
#include <array>
#include <functional>
#include <tuple>

namespace merker {
namespace {

constexpr std::array kProblems{
#define PROBLEM(code, severity, text) ProblemInfo{#code, Severity::severity, text},
#include "base/problems.inc"
#undef PROBLEM
};

auto key(const Problem& p) { return std::tie(p.position.file, p.position.line, p.position.column); }

}  // namespace

const ProblemInfo& info(ProblemCode code) { return kProblems[static_cast<std::size_t>(code)]; }

Problem composeProblem(ProblemCode code, Position position, std::vector<std::string> arguments) {
  fmt::dynamic_format_arg_store<fmt::format_context> places;
  for (const std::string& argument : arguments) places.push_back(std::cref(argument));
  std::string message = fmt::vformat(info(code).text, places);
  return {code, std::move(position), std::move(message), std::move(arguments)};
}

bool Problems::hasErrors() const {
  return std::any_of(list_.begin(), list_.end(),
                     [](const Problem& p) { return p.severity() == Severity::Error; });
}

void Problems::sort() {
  std::stable_sort(list_.begin(), list_.end(),
                   [](const Problem& a, const Problem& b) { return key(a) < key(b); });
}

}  // namespace merker
