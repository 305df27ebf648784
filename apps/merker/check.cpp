// merker check PATH...
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "build.h"
#include "command.h"
#include "cpu_option.h"

namespace merker::app {
namespace {

struct CheckOptions {
  std::vector<std::string> paths;
  ProjectOptions project;
  bool json = false;
};

// "1 block", "2 blocks"
std::string counted(std::size_t number, std::string_view what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

void summary(const Build& build) {
  std::cout << build.project.path << ": " << counted(build.blocks(), "block") << ", "
            << counted(build.problems.count(Severity::Error), "error") << ", "
            << counted(build.problems.count(Severity::Warning), "warning") << '\n';
}

int check(const CheckOptions& options) {
  int result = kGood;
  Problems problems;
  for (const std::string& path : options.paths) {
    Build checked = build(loadProject(path, options.project), false);
    noteMissingOb1(checked);
    printProblems(checked.problems, checked.files());
    problems.append(checked.problems);
    if (!options.json) summary(checked);
    result = std::max(result, exitCode(checked));
  }
  if (options.json) print({{"problems", toJson(problems)}});
  return result;
}

}  // namespace

void addCheck(CLI::App& program, int& result) {
  auto* command =
      program.add_subcommand("check", "compile and link, print all problems, run nothing");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("PATH", options->paths, "project folders or sources")->required();
  addProjectOptions(*command, options->project);
  command->add_flag("--json", options->json, "problems as JSON on standard output, too");
  command->footer(
      "Examples:\n  merker check examples/sorting-plant\n  merker check --cpu generic a.awl b.awl");
  command->callback([options, &result] { result = check(*options); });
}

}  // namespace merker::app
