#include "cpu_option.h"

#include <CLI/CLI.hpp>

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
  command
      .add_option("--source-mnemonics", options.mnemonics,
                  "language of the AWL sources, german or english, instead of the project's")
      ->check(CLI::IsMember({"german", "english"}));
}

project::Project loadProject(const std::string& path, const ProjectOptions& options) {
  return withMnemonics(project::load(path, options.cpu), options.mnemonics);
}

project::Project loadSources(const std::vector<std::string>& sources,
                             const ProjectOptions& options) {
  return withMnemonics(project::loadSources(sources.front(), sources, options.cpu),
                       options.mnemonics);
}

}  // namespace merker::app
