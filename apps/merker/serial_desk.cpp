#include "serial_desk.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "server/guard.h"

namespace merker::app {
namespace {

using serial::Connection;
using Kind = Connection::Kind;

std::string toText(const Connection& connection) {
  constexpr const char* kKinds[] = {"partner", "pty",     "device", "listen",
                                    "connect", "rfc2217", "replay", "station"};
  const char* kind = kKinds[static_cast<std::size_t>(connection.kind)];
  const bool network = connection.kind == Kind::Listen || connection.kind == Kind::Connect ||
                       connection.kind == Kind::ComPort;
  if (connection.kind == Kind::Partner) return kind;
  if (!network) return fmt::format("{}:{}", kind, connection.place);
  return fmt::format("{}:{}{}{}", kind, connection.place, connection.place.empty() ? "" : ":",
                     connection.port);
}

bool isPlainName(const std::string& name) {
  return name.find('/') == std::string::npos && name != "." && name != "..";
}

// Within the project folder, or for callers on this computer.
bool staysHere(const Connection& connection) {
  switch (connection.kind) {
    case Kind::Partner:
    case Kind::Station:
      return true;
    case Kind::Listen:
      return connection.place.empty() || hmi::isLocalAddress(connection.place);
    case Kind::Pty:
    case Kind::Replay:
      return isPlainName(connection.place);
    case Kind::Device:
    case Kind::Connect:
    case Kind::ComPort:
      return false;
  }
  return false;
}

Connection within(Connection connection, const std::string& folder) {
  if (connection.kind == Kind::Pty || connection.kind == Kind::Replay)
    connection.place = (std::filesystem::path(folder) / connection.place).string();
  return connection;
}

}  // namespace

SerialDesk::SerialDesk(workbench::Workbench& workbench, std::optional<Connection> allowed)
    : workbench_(workbench), allowed_(std::move(allowed)) {
  if (workbench.plc() != nullptr) project_ = workbench.plc()->build().project.path;
}

void SerialDesk::use(std::unique_ptr<SerialLink> link) {
  if (!link) return;
  link_ = std::move(link);
  connection_ = allowed_;
  shown_ = workbench_.shown();
}

std::string SerialDesk::whyNot(const Connection& connection) const {
  if (connection == allowed_ || staysHere(connection)) return {};
  return "only for the project of the command line: merker workbench FOLDER";
}

// A configuration that was loaded makes another PLC of the same project.
void SerialDesk::follow() {
  shown_ = workbench_.shown();
  link_.reset();
  problem_.clear();
  connection_.reset();
  workbench::Plc* const plc = workbench_.plc();
  if (plc == nullptr) return;
  const project::Project& project = plc->build().project;
  connection_ = project.path == project_ && allowed_ ? allowed_ : project.serial;
  if (!connection_ || connection_->kind == Kind::Partner) return connection_.reset();
  if (connection_->kind == Kind::Station) return;  // it is part of the PLC
  problem_ = whyNot(*connection_);
  if (!problem_.empty()) return;
  const bool own = connection_ == allowed_;
  link_ = SerialLink::open(own ? *connection_ : within(*connection_, project.folder), {},
                           plc->controller(), problem_);
  if (link_) std::cerr << "serial interface X27: " << link_->name() << std::endl;
}

void SerialDesk::exchange() {
  if (workbench_.shown() != shown_) follow();
  if (link_) link_->exchange();
}

workbench::SerialOutside SerialDesk::outside() const {
  if (!connection_) return {};
  const bool connected =
      link_ ? link_->connected() : connection_->kind == Kind::Station && problem_.empty();
  return {toText(*connection_), link_ ? link_->name() : "", connected, problem_};
}

}  // namespace merker::app
