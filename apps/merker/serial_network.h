// A serial line over TCP: a raw stream of characters, one connection at a time (PTP-LINE-06).
#pragma once

#include "serial_stream.h"

namespace merker::app {

std::unique_ptr<SerialStream> listenAt(const std::string& host, std::uint16_t port,
                                       std::string& reason);
// Calls again every second while nobody answers.
std::unique_ptr<SerialStream> connectTo(const std::string& host, std::uint16_t port,
                                        std::string& reason);

// The same to a server of serial ports, which is set as the interface is (RFC 2217).
std::unique_ptr<SerialStream> connectToComPort(const std::string& host, std::uint16_t port,
                                               const serial::Settings& settings,
                                               std::string& reason);

}  // namespace merker::app
