#include "network_workbench.h"

#include <iostream>

#include "command.h"
#include "output.h"
#include "serial_desk.h"

namespace merker::app {

// A project with errors is opened, too: here is where they are mended.
int runNetworkWorkbench(const std::string& command, const ServeOptions& options,
                        project::Project project) {
  Problems problems;
  auto lab = workbench::makeLaboratory(std::move(project), {}, problems);
  printProblems(problems,
                [&](const std::string& name) { return lab ? lab->build.files()(name) : nullptr; });
  if (!lab) return kProblems;
  workbench::Workbench workbench;
  workbench.show(std::move(lab));
  SerialDesk serial(workbench, std::nullopt);
  return serve(command, options, workbench, false, serial);
}

}  // namespace merker::app
