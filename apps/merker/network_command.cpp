// merker network PATH
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "command.h"
#include "cpu_option.h"
#include "network_plan.h"
#include "output.h"

namespace merker::app {
namespace {

struct NetworkOptions {
  std::string path, svg;
  bool json = false;
};

int networkRefused(const std::string& text, int code) {
  std::cerr << "merker network: " << text << '\n';
  return code;
}

int writeSvg(const std::string& path, const NetworkPlan& plan) {
  std::ofstream file(path, std::ios::binary);
  file << toSvg(plan);
  file.close();
  if (file) return kGood;
  return networkRefused(fmt::format("cannot write {}: {}", path, std::strerror(errno)),
                        kUnreadable);
}

// The exit code.
int show(const NetworkOptions& options, const NetworkPlan& plan, const Problems& problems) {
  if (options.json) {
    nlohmann::ordered_json document = toJson(plan);
    document["problems"] = toJson(problems);
    std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  } else {
    std::cout << toText(plan);
  }
  if (!options.svg.empty())
    if (const int code = writeSvg(options.svg, plan)) return code;
  return problems.hasErrors() ? kProblems : kGood;
}

int showStation(const NetworkOptions& options, project::Project project) {
  const auto build = compilation::build(std::move(project), false);
  printProblems(build.problems, build.files());
  const int code = show(options, planOf(build), build.problems);
  return build.project.unreadable ? kUnreadable : code;
}

int network(const NetworkOptions& options) {
  project::Project project = loadProject(options.path, {});
  if (!project.network && project.problems.hasErrors()) {
    printProblems(project.problems, [&](const auto& name) { return project.file(name); });
    return project.unreadable ? kUnreadable : kProblems;
  }
  if (!project.network) return showStation(options, std::move(project));
  const auto build = compilation::buildNetwork(std::move(project), false);
  printProblems(build.problems, build.files());
  NetworkPlan plan = planOf(build);
  addProfibus(build, plan);
  const int code = show(options, plan, build.problems);
  return build.unreadable ? kUnreadable : code;
}

}  // namespace

void addNetwork(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "network", "stations, subnets, DP slaves and connections of a project");
  auto options = std::make_shared<NetworkOptions>();
  command->add_option("PATH", options->path, "project folder")->required();
  command->add_flag("--json", options->json, "as one JSON object, with the problems");
  command->add_option("--svg", options->svg, "file for the drawing");
  command->footer(
      "Examples:\n  merker network examples/networks/laboratory\n  merker network "
      "examples/networks/token-ring --svg ring.svg");
  command->callback([options, &result] { result = network(*options); });
}

}  // namespace merker::app
