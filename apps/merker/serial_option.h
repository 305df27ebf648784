// The connection of X27 on the command line.
#pragma once

#include <memory>
#include <string>

#include "build.h"
#include "serial_link.h"

namespace CLI {
class App;
}

namespace merker::app {

struct SerialOptions {
  std::string connection, record;
};
void addSerial(CLI::App& command, SerialOptions& options);
// What the command line connects X27 to, in place of what the project says. The exit code.
int connectSerial(const SerialOptions& options, project::Project& project);
// The connection of the command line, else that of merker.toml; null: the partner of scenarios. The
// exit code; what is wrong is told.
int openSerial(const SerialOptions& options, const Build& build, bool virtualTime,
               controller::Controller& plc, std::unique_ptr<SerialLink>& link);

}  // namespace merker::app
