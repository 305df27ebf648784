#include "serial_stream.h"

#include <cerrno>
#include <cstring>

#include "serial_device.h"
#include "serial_network.h"

namespace merker::app {

std::unique_ptr<SerialStream> openStream(const serial::Connection& connection,
                                         const serial::Settings& settings, std::string& reason) {
  using Kind = serial::Connection::Kind;
  switch (connection.kind) {
    case Kind::Pty:
      return openPty(connection.place, reason);
    case Kind::Device:
      return openDevice(connection.place, settings, reason);
    case Kind::Listen:
      return listenAt(connection.place, connection.port, reason);
    case Kind::Connect:
      return connectTo(connection.place, connection.port, reason);
    case Kind::ComPort:
      return connectToComPort(connection.place, connection.port, settings, reason);
    case Kind::Partner:
    case Kind::Station:
    case Kind::Replay:
      break;
  }
  reason = "this is no connection to the outside";
  return nullptr;
}

}  // namespace merker::app
