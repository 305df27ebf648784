#include "cpu_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "project/settings.h"

namespace merker::app {
namespace {

std::string checkCpu(const std::string& name) {
  if (project::findModel(name)) return {};
  return "CPU model '" + name + "' not found; valid models: " + project::modelNames();
}

project::Project withMnemonics(project::Project project, const std::string& word) {
  if (!word.empty())
    project.mnemonics = word == "german" ? Mnemonics::German : Mnemonics::International;
  return project;
}

}  // namespace

void addProjectOptions(CLI::App& command, ProjectOptions& options) {
  command.add_option("--cpu", options.cpu, "CPU model instead of the project's")->check(checkCpu);
  command.add_option("--station", options.station,
                     "of a project of several stations this one alone");
  command
      .add_option("--source-mnemonics", options.mnemonics,
                  "language of the AWL sources, german or english, instead of the project's")
      ->check(CLI::IsMember({"german", "english"}));
}

namespace {

// The one that --station names, as if its folder had been given.
project::Project narrowed(project::Project project, const ProjectOptions& options) {
  if (options.station.empty()) return project;
  const auto refuse = [&](const std::string& what) {
    project.problems.add(ProblemCode::P0704, Position{project.path}, "--station", what);
    return std::move(project);
  };
  if (project.unreadable) return project;
  if (!project.network) return refuse("left out: the project has one station only");
  const auto& stations = project.network->stations;
  const auto found = std::ranges::find_if(stations, [&](const project::OtherStation& one) {
    return equalsIgnoreCase(one.name, options.station);
  });
  if (found == stations.end())
    return refuse("the name of a station: " + stationNames(*project.network));
  const auto folder = std::filesystem::path(project.folder) / found->folder;
  return project::load(folder.lexically_normal().string(), options.cpu);
}

}  // namespace

project::Project loadProject(const std::string& path, const ProjectOptions& options) {
  return withMnemonics(narrowed(project::load(path, options.cpu), options), options.mnemonics);
}

project::Project loadSources(const std::vector<std::string>& sources,
                             const ProjectOptions& options) {
  return withMnemonics(project::loadSources(sources.front(), sources, options.cpu),
                       options.mnemonics);
}

}  // namespace merker::app
