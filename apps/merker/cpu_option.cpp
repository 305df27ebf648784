#include "cpu_option.h"

#include <CLI/CLI.hpp>
#include <filesystem>

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

[[noreturn]] void refuseStation(const std::string& what) {
  throw CLI::ValidationError("--station", what);
}

}  // namespace

std::string chosenPath(const std::string& path, const ProjectOptions& options) {
  if (options.station.empty()) return path;
  const project::Project project = project::load(path, {});
  if (!project.network) {
    if (project.unreadable || project.problems.hasErrors()) return path;  // which is told
    refuseStation(path + " has one station only; leave the option out");
  }
  const auto number = findStation(*project.network, options.station);
  if (!number)
    refuseStation("there is no station '" + options.station + "' in " + path +
                  "; its stations are " + stationNames(*project.network));
  const std::string& folder = project.network->stations[*number].folder;
  return (std::filesystem::path(project.folder) / folder).lexically_normal().string();
}

project::Project loadProject(const std::string& path, const ProjectOptions& options) {
  return withMnemonics(project::load(chosenPath(path, options), options.cpu), options.mnemonics);
}

project::Project loadSources(const std::vector<std::string>& sources,
                             const ProjectOptions& options) {
  return withMnemonics(project::loadSources(sources.front(), sources, options.cpu),
                       options.mnemonics);
}

}  // namespace merker::app
