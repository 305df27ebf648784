#include "workbench/json.h"

#include <algorithm>

namespace merker::workbench {
namespace {

// What begins like a source may be one word of many megabytes.
constexpr std::size_t kLongestText = 400;

std::string shortened(const std::string& text) {
  if (text.size() <= kLongestText) return text;
  std::size_t end = kLongestText;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // not inside a character
  return text.substr(0, end) + " …";
}

}  // namespace

Answer::Answer(const Problems& problems) : good_(false), json_(firstOf(problems)) {}

Answer Answer::refused(Json list) {
  Answer answer(std::move(list));
  answer.good_ = false;
  return answer;
}

Answer Answer::later(std::shared_ptr<Later> later) {
  Answer answer{Json(nullptr)};
  answer.later_ = std::move(later);
  return answer;
}

Answer Answer::written(bool good, std::string text) {
  Answer answer{Json(nullptr)};
  answer.good_ = good;
  answer.text_ = std::move(text);
  return answer;
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json toJson(const Problem& problem) {
  const Position& at = problem.position;
  Json arguments = Json::array();
  for (const std::string& argument : problem.arguments) arguments.push_back(shortened(argument));
  return {{"code", problem.name()},
          {"severity", problem.severity() == Severity::Error ? "error" : "warning"},
          {"file", at.file},
          {"line", at.line},
          {"column", at.column},
          {"length", at.length},
          {"text", shortened(problem.message)},
          {"arguments", std::move(arguments)}};
}

Json toJson(const Problems& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems.list()) list.push_back(toJson(problem));
  return list;
}

Json firstOf(const Problems& problems) {
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(problems.size(), kMostProblems); ++i)
    list.push_back(toJson(problems.list()[i]));
  return list;
}

Problems one(Problem problem) {
  Problems problems;
  problems.add(std::move(problem));
  return problems;
}

Position nowhere() { return Position{"", 0, 0, 0}; }

}  // namespace merker::workbench
