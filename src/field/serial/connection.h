// What the interface X27 of a station is connected to outside of the simulation: a setting of the
// simulator, no part of the S7 project (PTP-LINE-12).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace merker::serial {

struct Connection {
  enum class Kind : std::uint8_t {
    Partner,  // of the simulation: scenarios say what it does
    Pty,      // a pseudo terminal; `place` becomes a link to it
    Device,   // a serial device of this computer
    Listen,   // TCP, this side waits; `place` is HOST or empty
    Connect,  // TCP, this side calls
    ComPort,  // TCP, this side calls a server of serial ports (RFC 2217)
    Replay,   // a recording of an earlier run
    Station   // another station of the project; `place` is its name
  };
  Kind kind = Kind::Partner;
  std::string place;  // path or host
  std::uint16_t port = 0;
  bool operator==(const Connection&) const = default;
};

// "pty:/tmp/x27", "device:/dev/ttyUSB0", "listen:4000", "listen:127.0.0.1:4000",
// "connect:host:4000", "rfc2217:host:4000", "replay:line.csv", "station:Press", "partner"; nothing
// if it is none of these.
std::optional<Connection> parseConnection(std::string_view text);
std::string_view connectionForms();  // for messages

}  // namespace merker::serial
