// Pseudo terminals and serial devices (termios; PTP-LINE-04, PTP-LINE-05).
#pragma once

#include "serial_stream.h"

namespace merker::app {

// `link`: a symbolic link to the pseudo terminal, made here and removed at the end.
std::unique_ptr<SerialStream> openPty(const std::string& link, std::string& reason);
std::unique_ptr<SerialStream> openDevice(const std::string& path, const serial::Settings& settings,
                                         std::string& reason);

}  // namespace merker::app
