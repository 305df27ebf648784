// The workbench of several stations.
#pragma once

#include <string>

#include "project/project.h"
#include "serve.h"

namespace merker::app {

// Until Ctrl-C. The exit code.
int runNetworkWorkbench(const std::string& command, const ServeOptions& options,
                        project::Project project);

}  // namespace merker::app
