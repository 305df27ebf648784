// --cpu NAME, --station NAME and --source-mnemonics LANGUAGE of every command that compiles.
#pragma once

#include <string>

#include "project/project.h"

namespace CLI {
class App;
}

namespace merker::app {

// What stands on the command line in place of what the project says.
struct ProjectOptions {
  std::string cpu, mnemonics;  // empty: as the project has it
  std::string station;         // empty: all, where the project has several
};

// An unknown name is wrong usage.
void addProjectOptions(CLI::App& command, ProjectOptions& options);

// The folder of the station that --station names; without it `path`. A name that no station has is
// wrong usage: CLI::ValidationError.
std::string chosenPath(const std::string& path, const ProjectOptions& options);
project::Project loadProject(const std::string& path, const ProjectOptions& options);
// Some sources as one program.
project::Project loadSources(const std::vector<std::string>& sources,
                             const ProjectOptions& options);

}  // namespace merker::app
