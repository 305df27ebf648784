// merker workbench [PATH]
#include <CLI/CLI.hpp>

#include "build.h"
#include "command.h"
#include "network_workbench.h"
#include "serial_desk.h"
#include "serve.h"

namespace merker::app {
namespace {

// A project with errors is opened, too: here is where they are mended.
int run(const ServeOptions& options) {
  workbench::Workbench workbench;
  if (!options.project.empty()) {
    project::Project project = project::load(options.project, {});
    if (project.network)
      return runNetworkWorkbench("merker workbench", options, std::move(project));
    Build built = build(std::move(project), false);
    requireWorkMemory(built);
    report(built, false);
    if (built.project.unreadable) return kUnreadable;
    workbench.show(std::make_unique<workbench::Plc>(std::move(built)));
  }
  SerialDesk serial(workbench, workbench.plc() == nullptr
                                   ? std::nullopt
                                   : workbench.plc()->build().project.serial);
  return serve("merker workbench", options, workbench, false, serial);
}

}  // namespace

void addWorkbench(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "workbench", "a PLC in the browser: examples, new projects, or the one at PATH");
  auto options = std::make_shared<ServeOptions>();
  command->add_option("PATH", options->project, "project folder or source; it may have errors");
  addServe(*command, *options);
  command->footer(
      "Examples:\n"
      "  merker workbench\n"
      "  merker workbench examples/sorting-plant --port 0\n"
      "  merker workbench --listen 0.0.0.0 --token SECRET --certificate c.pem --key k.pem");
  command->callback([options, &result] { result = run(*options); });
}

}  // namespace merker::app
