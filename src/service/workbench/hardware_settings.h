// What is set on the CPU, on modules and on their channels, as properties of rows of hardware: by
// the keys of merker.toml, "input 0 range" for that of a channel.
#pragma once

#include "io/configuration.h"
#include "project/project.h"
#include "workbench/json.h"

namespace merker::workbench {

// To the rows of hardwareRows(), whatever state their modules are in.
void addSettings(const project::Project& project, const io::Configuration& hardware, Json& racks);

}  // namespace merker::workbench
