#include "serial_option.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "command.h"

namespace merker::app {
namespace {

using Kind = serial::Connection::Kind;

int serialFails(const std::string& text, ExitCode code) {
  std::cerr << "merker run: " << text << '\n';
  return code;
}

}  // namespace

void addSerial(CLI::App& command, SerialOptions& options) {
  auto* serial = command.add_option(
      "--serial", options.connection,
      "what the interface X27 is connected to: pty:PATH, device:PATH, listen:PORT, "
      "connect:HOST:PORT, rfc2217:HOST:PORT, replay:FILE");
  command
      .add_option("--serial-record", options.record,
                  "file for what comes in over --serial, to be played again")
      ->needs(serial);
}

int connectSerial(const SerialOptions& options, project::Project& project) {
  if (options.connection.empty()) return kGood;
  const auto connection = serial::parseConnection(options.connection);
  if (!connection)
    return serialFails("--serial: '" + options.connection + "' is not a valid connection; " +
                           std::string(serial::connectionForms()),
                       kUsage);
  if (connection->kind == Kind::Station)
    return serialFails("--serial: a station is connected in merker.toml, with [[station]]", kUsage);
  project.serial = connection;
  project.stations.clear();
  return kGood;
}

// A run in virtual time has the partner, whatever merker.toml says: nobody outside is so fast.
int openSerial(const SerialOptions& options, const Build& build, bool virtualTime,
               controller::Controller& plc, std::unique_ptr<SerialLink>& link) {
  const auto& connection = build.project.serial;
  if (!connection || connection->kind == Kind::Station) return kGood;
  const bool outside = connection->kind != Kind::Partner && connection->kind != Kind::Replay;
  if (outside && virtualTime) {
    if (options.connection.empty()) return kGood;
    return serialFails("--serial: the outside needs real time; --for and --cycles take replay:FILE",
                       kUsage);
  }
  std::string reason;
  link = SerialLink::open(*connection, options.record, plc, reason);
  if (!reason.empty()) return serialFails("serial interface: " + reason, kUnreadable);
  if (link && link->realTime()) std::cerr << "serial interface X27: " << link->name() << std::endl;
  return kGood;
}

}  // namespace merker::app
