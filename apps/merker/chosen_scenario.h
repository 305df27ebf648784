// The one scenario that a command runs (--scenario FILE, --name TEXT).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "build.h"
#include "compilation/network.h"
#include "scenario/scenario.h"
#include "source/source_file.h"

namespace merker::app {

struct ChosenScenario {
  source::SourceFile file;  // the scenario's texts are views into it
  simulator::Scenario scenario;
};

// The scenarios of a file, bound to the operands, modules and plants of `built`.
std::vector<simulator::Scenario> boundScenarios(const source::SourceFile& file, const Build& built,
                                                Problems& problems);

std::vector<simulator::Scenario> boundScenarios(const source::SourceFile& file,
                                                const compilation::NetworkBuild& built,
                                                Problems& problems);

// The first scenario whose name contains `name`, in any case; all names contain an empty one.
// Prints what is wrong, with `command` before a message of its own. `code` becomes the exit code
// if there is no such scenario.
std::unique_ptr<const ChosenScenario> chooseScenario(const std::string& command,
                                                     const std::string& path,
                                                     const std::string& name, const Build& built,
                                                     int& code);

}  // namespace merker::app
