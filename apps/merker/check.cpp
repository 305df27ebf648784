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
#include "compilation/network.h"
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

bool isFile(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

bool isSource(const std::string& path) {
  return equalsIgnoreCase(std::filesystem::path(path).extension().string(), ".awl") && isFile(path);
}

// With the symbol files of the command line, except those that lie beside the source and are known.
Build built(project::Project project, const std::vector<std::string>& lists) {
  for (const std::string& list : lists) {
    if (project.file(list) != nullptr) continue;
    auto file = source::readSource(list);
    if (!file) {
      project.problems.add(file.error());
      continue;
    }
    project.otherFiles.push_back(std::move(file.value()));
    source::readSymbols(project.otherFiles.back(), project.symbols, project.problems);
  }
  return build(std::move(project), false);
}

// A source alone names no CPU, and was perhaps written for a larger one than the default.
void noteLimits(const Build& checked, const std::string& path,
                const std::vector<std::string>& lists, const ProjectOptions& options) {
  constexpr const char* kUnlimited = "generic-4";
  if (checked.ok() || !options.cpu.empty() || !isSource(path)) return;
  ProjectOptions other = options;
  other.cpu = kUnlimited;
  const std::size_t errors = built(loadProject(path, other), lists).problems.count(Severity::Error);
  if (errors < checked.problems.count(Severity::Error))
    std::cerr << fmt::format("{}: {} with --cpu {}, which has no limits; the default is {}\n",
                             visible(path), counted(errors, "error"), kUnlimited,
                             checked.project.model->name);
}

void summary(const compilation::NetworkBuild& build) {
  std::cout << build.project.path << ": " << counted(build.stations.size(), "station") << ", "
            << counted(build.blocks(), "block") << ", "
            << counted(build.problems.count(Severity::Error), "error") << ", "
            << counted(build.problems.count(Severity::Warning), "warning") << '\n';
}

// The exit code; what is wrong is added to `problems`, too.
int checkNetwork(project::Project project, bool json, Problems& problems) {
  const auto checked = compilation::buildNetwork(std::move(project), false);
  printProblems(checked.problems, checked.files());
  problems.append(checked.problems);
  if (!json) summary(checked);
  if (checked.unreadable) return kUnreadable;
  return checked.ok() ? kGood : kProblems;
}

int check(const CheckOptions& options) {
  int result = kGood;
  Problems problems;
  std::vector<std::string> lists, programs;
  for (const std::string& path : options.paths)
    (source::isSymbolFile(path) && isFile(path) ? lists : programs).push_back(path);
  if (programs.empty()) programs.swap(lists);  // which says that there is no program
  for (const std::string& path : programs) {
    project::Project project = loadProject(path, options.project);
    if (project.network) {
      result = std::max(result, checkNetwork(std::move(project), options.json, problems));
      continue;
    }
    Build checked = built(std::move(project), lists);
    noteMissingOb1(checked);
    printProblems(checked.problems, checked.files());
    noteLimits(checked, path, lists, options.project);
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
  command
      ->add_option("PATH", options->paths, "project folders or sources, and symbol files for them")
      ->required();
  addProjectOptions(*command, options->project);
  command->add_flag("--json", options->json, "problems as JSON on standard output, too");
  command->footer(
      "Examples:\n  merker check examples/sorting-plant\n  merker check --cpu generic a.awl b.awl "
      "names.sdf");
  command->callback([options, &result] { result = check(*options); });
}

}  // namespace merker::app
