#include "base/problem.h"

#include <fmt/args.h>

#include <algorithm>
#include <array>
#include <functional>
#include <tuple>

#include "base/visible.h"

namespace merker {
namespace {

constexpr std::array kProblems{
#define PROBLEM(code, severity, text) ProblemInfo{#code, Severity::severity, text},
#include "base/problems.inc"
#undef PROBLEM
};

// Says how many there are besides.
bool isRest(const Problem& p) { return p.code == ProblemCode::P0105; }

auto key(const Problem& p) {
  return std::tuple(isRest(p), std::string_view(p.position.file), p.position.line,
                    p.position.column);
}

std::string shortened(std::string text) {
  if (text.size() <= kLongestArgument) return text;
  std::size_t end = kLongestArgument;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // not inside a character
  text.resize(end);
  return text + " …";
}

}  // namespace

const ProblemInfo& info(ProblemCode code) { return kProblems[static_cast<std::size_t>(code)]; }

Problem composeProblem(ProblemCode code, Position position, std::vector<std::string> arguments) {
  for (std::string& argument : arguments) argument = shortened(visible(argument));
  fmt::dynamic_format_arg_store<fmt::format_context> places;
  for (const std::string& argument : arguments) places.push_back(std::cref(argument));
  std::string message = fmt::vformat(info(code).text, places);
  return {code, std::move(position), std::move(message), std::move(arguments)};
}

std::size_t Problems::kept(Severity severity) const {
  const auto same = [severity](const Problem& p) { return !isRest(p) && p.severity() == severity; };
  return static_cast<std::size_t>(std::count_if(list_.begin(), list_.end(), same));
}

void Problems::append(const Problems& other) {
  for (const Problem& problem : other.list_)
    if (!isRest(problem)) add(problem);
  for (const Severity severity : {Severity::Error, Severity::Warning})
    number(severity) += other.count(severity) - other.kept(severity);
}

void Problems::remove(ProblemCode code) {
  const auto same = [code](const Problem& p) { return p.code == code; };
  number(info(code).severity) -= std::erase_if(list_, same);
}

void Problems::sort() {
  std::stable_sort(list_.begin(), list_.end(),
                   [](const Problem& a, const Problem& b) { return key(a) < key(b); });
}

void Problems::tellRest(const Position& position) {
  std::erase_if(list_, isRest);
  if (size() == list_.size()) return;
  list_.push_back(makeProblem(ProblemCode::P0105, position,
                              count(Severity::Error) - kept(Severity::Error),
                              count(Severity::Warning) - kept(Severity::Warning)));
}

}  // namespace merker
