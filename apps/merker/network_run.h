// merker run of a project of several stations.
#pragma once

#include "clock/instant.h"
#include "project/project.h"
#include "run_options.h"

namespace merker::app {

// Without `time` in real time. The exit code.
int runNetwork(const RunOptions& options, project::Project project, std::optional<Duration> time);

}  // namespace merker::app
