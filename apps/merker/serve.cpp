#include "serve.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "desk.h"
#include "page.h"
#include "real_time.h"

namespace merker::app {

void addServe(CLI::App& command, ServeOptions& options) {
  command.add_option("--port", options.port, "port of the workbench (8080); 0: any free one");
  command.add_option("--listen", options.listen,
                     "address of the workbench (127.0.0.1); any other computer needs --token, "
                     "--certificate and --key");
  command.add_option("--token", options.token, "what the page's address must end with: ?token=...");
  auto* certificate = command.add_option("--certificate", options.certificate,
                                         "certificate chain (PEM): the workbench is served by TLS");
  command.add_option("--key", options.key, "its private key (PEM)")->needs(certificate);
}

namespace {

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

}  // namespace

bool serve(const std::string& command, const ServeOptions& options, workbench::Workbench& workbench,
           bool quiet) {
  holdSignals();
  Desk desk(workbench);
  std::string reason;
  const auto server = hmi::Server::start(toOptions(options), desk, reason);
  if (!server) {
    std::cerr << command << ": " << reason << '\n';
    return false;
  }
  (quiet ? std::cerr : std::cout) << "workbench: " << server->url() << '/'
                                  << (options.token.empty() ? "" : "?token=" + options.token)
                                  << "  (Ctrl-C ends it)" << std::endl;
  desk.run(*server, endAsked);
  return true;
}

}  // namespace merker::app
