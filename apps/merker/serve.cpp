#include "serve.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "command.h"
#include "desk.h"
#include "laboratory_s7.h"
#include "page.h"
#include "real_time.h"
#include "serial_desk.h"

namespace merker::app {

void addServe(CLI::App& command, ServeOptions& options) {
  command.add_option("--port", options.port, "port of the workbench (8080); 0: any free one");
  command.add_option("--listen", options.listen,
                     "address of the workbench (127.0.0.1); any other computer needs --token, "
                     "--certificate and --key");
  command.add_option("--token", options.token,
                     "the address of the page must end with ?token=...; 16 characters or more");
  auto* certificate = command.add_option("--certificate", options.certificate,
                                         "certificate chain (PEM): the workbench is served by TLS");
  command.add_option("--key", options.key, "its private key (PEM)")->needs(certificate);
  command.add_option("--workspace", options.workspace,
                     "folder for projects of the workbench (merker in your home)");
  command.add_option("--examples", options.examples, "folder of the examples");
  addS7(command, options.s7);
}

namespace {

namespace fs = std::filesystem;

std::string workspaceFolder(const ServeOptions& options) {
  if (!options.workspace.empty()) return options.workspace;
  const char* home = std::getenv("HOME");
  return (fs::path(home == nullptr ? "." : home) / "merker").string();
}

// Beside the program: in the clone it was built in, or where it was installed.
std::string examplesFolder(const ServeOptions& options) {
  if (!options.examples.empty()) return options.examples;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* way : {"../../examples", "examples", "../share/merker/examples"}) {
    const fs::path folder = program / way;
    if (fs::is_regular_file(folder / "README.md", error)) return fs::canonical(folder).string();
  }
  return {};
}

hmi::Options toOptions(const ServeOptions& given) {
  hmi::Options options;
  options.address = given.listen;
  options.port = given.port;
  options.token = given.token;
  options.certificate = given.certificate;
  options.key = given.key;
  options.assets = page();
  return options;
}

int refused(const std::string& command, const std::string& reason, ExitCode code) {
  std::cerr << command << ": " << reason << '\n';
  return code;
}

// docs/workbench-protocol.md, the event "stalled".
std::string stalled(const std::string& place, std::int64_t seconds) {
  const workbench::Json event = {{"event", "stalled"}, {"place", place}, {"seconds", seconds}};
  return workbench::dump(event);
}

}  // namespace

int serve(const std::string& command, const ServeOptions& options, workbench::Workbench& workbench,
          bool quiet, SerialDesk& serial) {
  const hmi::Options wanted = toOptions(options);
  std::string reason = hmi::wrongOptions(wanted);
  if (!reason.empty()) return refused(command, reason, kUsage);

  workbench::Upload::sweep();  // of those that were killed
  holdSignals();
  workbench::Workbenches workbenches(workbench);
  workbenches.each([&](workbench::Workbench& one) {
    one.use({workspaceFolder(options), examplesFolder(options), options.project});
  });
  Watchdog watchdog(command);
  Desk desk(workbenches, watchdog);
  LaboratoryS7 s7(workbench);
  desk.eachSlice([&] {
    serial.exchange();
    s7.exchange();
  });
  desk.waitedFor([&] { return s7.waits(); });
  workbench.serialBy([&] { return serial.outside(); });
  workbench.s7By([&] { return s7.outside(); });
  const auto server = hmi::Server::start(wanted, desk, reason);
  if (!server) return refused(command, reason, kUnreadable);
  if (const int bad = s7.open(command, options.s7, [&] { desk.hurry(); })) return bad;
  (quiet ? std::cerr : std::cout) << "workbench: " << server->url() << '/'
                                  << (options.token.empty() ? "" : "?token=" + options.token)
                                  << "  (Ctrl-C ends it)" << std::endl;
  watchdog.tellBy([&](const std::string& place, std::int64_t seconds) {
    server->sendAll(stalled(place, seconds));
  });
  desk.run(*server, endAsked);
  watchdog.tellBy({});
  workbench.serialBy([] { return workbench::SerialOutside(); });
  workbench.s7By([] { return workbench::S7Outside(); });
  releaseSignals();  // whoever asks twice does not want to wait
  return kGood;
}

}  // namespace merker::app
