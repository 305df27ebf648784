// merker check PATH...
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "base/visible.h"
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

bool isSource(const std::string& path) {
  std::error_code error;
  return equalsIgnoreCase(std::filesystem::path(path).extension().string(), ".awl") &&
         std::filesystem::is_regular_file(path, error);
}

// A source alone names no CPU, and was perhaps written for a larger one than the default.
void noteLimits(const Build& checked, const std::string& path, const ProjectOptions& options) {
  constexpr const char* kUnlimited = "generic-4";
  if (checked.ok() || !options.cpu.empty() || !isSource(path)) return;
  ProjectOptions other = options;
  other.cpu = kUnlimited;
  const std::size_t errors = build(loadProject(path, other), false).problems.count(Severity::Error);
  if (errors < checked.problems.count(Severity::Error))
    std::cerr << fmt::format(
        "{}: without the limits of {}, the default, there are {}; --cpu names another model, {} "
        "has "
        "no limits\n",
        visible(path), checked.project.model->name, counted(errors, "error"), kUnlimited);
}

int check(const CheckOptions& options) {
  int result = kGood;
  Problems problems;
  for (const std::string& path : options.paths) {
    Build checked = build(loadProject(path, options.project), false);
    noteMissingOb1(checked);
    printProblems(checked.problems, checked.files());
    noteLimits(checked, path, options.project);
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
