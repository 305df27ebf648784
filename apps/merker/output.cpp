#include "output.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "simulator/display.h"

namespace merker::app {

void printProblems(Problems problems, const FileLookup& files) {
  problems.sort();
  for (const Problem& problem : problems.list()) {
    const std::string text = source::format(problem, files(problem.position.file));
    std::cerr << text << (text.ends_with('\n') ? "" : "\n");
  }
}

nlohmann::json toJson(Problems problems) {
  problems.sort();
  nlohmann::json list = nlohmann::json::array();
  for (const Problem& problem : problems.list())
    list.push_back({{"file", problem.position.file},
                    {"line", problem.position.line},
                    {"column", problem.position.column},
                    {"length", problem.position.length},
                    {"severity", problem.severity() == Severity::Error ? "error" : "warning"},
                    {"code", problem.name()},
                    {"message", problem.message}});
  return list;
}

nlohmann::json toJson(const mc7::Reference& reference, std::uint32_t bits) {
  return std::visit([](auto value) { return nlohmann::json(value); },
                    simulator::numericValue(reference, bits));
}

void print(const nlohmann::json& document) {
  std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

}  // namespace merker::app
