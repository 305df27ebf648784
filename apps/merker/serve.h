// The workbench behind a server: options of the command line, start, and the time until Ctrl-C.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "s7_option.h"
#include "server/server.h"
#include "workbench/workbench.h"

namespace CLI {
class App;
}

namespace merker::app {

struct ServeOptions {
  std::uint16_t port = 8080;
  std::string listen = "127.0.0.1", token, certificate, key, workspace, examples;
  std::string project;  // of the command line
  S7Option s7;
};

void addServe(CLI::App& command, ServeOptions& options);
// Serves until Ctrl-C: the exit code, 2 or 4 if it could not listen; that is told. `quiet`:
// standard output is for something else.
// The serial interface of the PLC that is shown is connected in front of each slice of time.
class SerialDesk;
int serve(const std::string& command, const ServeOptions& options, workbench::Workbench& workbench,
          bool quiet, SerialDesk& serial);

}  // namespace merker::app
