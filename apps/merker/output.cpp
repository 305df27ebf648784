#include "output.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "scenario/display.h"
#include "scenario/long_value.h"

namespace merker::app {

namespace {

// What begins like a source may be one word of 100 MB.
constexpr std::size_t kLongestMessage = 400, kLongestLine = 2000;

std::string shortened(std::string message) {
  if (message.size() <= kLongestMessage) return message;
  std::size_t end = kLongestMessage;
  while (end > 0 && (message[end] & 0xC0) == 0x80) --end;  // not inside a character
  return message.substr(0, end) + " …";
}

// Without its line if that is too long to be read.
const source::SourceFile* shown(const Problem& problem, const source::SourceFile* file) {
  const std::uint32_t line = problem.position.line;
  if (file == nullptr || line == 0 || line > file->lineCount()) return file;
  return file->line(line).size() <= kLongestLine ? file : nullptr;
}

}  // namespace

void printProblems(Problems problems, const FileLookup& files) {
  problems.tellRest({});
  problems.sort();
  for (Problem problem : problems.list()) {
    problem.message = shortened(std::move(problem.message));
    const std::string text = source::format(problem, shown(problem, files(problem.position.file)));
    std::cerr << text << (text.ends_with('\n') ? "" : "\n");
  }
}

nlohmann::json toJson(Problems problems) {
  problems.tellRest({});
  problems.sort();
  nlohmann::json list = nlohmann::json::array();
  for (const Problem& problem : problems.list())
    list.push_back({{"file", problem.position.file},
                    {"line", problem.position.line},
                    {"column", problem.position.column},
                    {"length", problem.position.length},
                    {"severity", problem.severity() == Severity::Error ? "error" : "warning"},
                    {"code", problem.name()},
                    {"message", shortened(problem.message)}});
  return list;
}

nlohmann::json toJson(const address::Reference& reference, const controller::Controller& plc) {
  if (simulator::isLong(reference)) {
    const auto content = simulator::readLong(reference, plc);
    if (content && reference.nc != 0) return std::stod(*content);
    return content ? nlohmann::json(simulator::plainLong(reference.type, *content)) : nullptr;
  }
  const auto bits = plc.read(reference);
  if (!bits) return nullptr;
  return std::visit([](auto value) { return nlohmann::json(value); },
                    simulator::numericValue(reference, *bits));
}

void print(const nlohmann::json& document) {
  std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

}  // namespace merker::app
