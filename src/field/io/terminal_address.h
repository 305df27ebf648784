// The terminal behind an address, as programs name it: E 20.0 (I 20.0), A 4.1 (Q 4.1), PEW 256
// (PIW 256, EW 256), PAW 256. Of a module of the racks, of a DP slave, or of an AS-i slave.
#pragma once

#include "io/configuration.h"
#include "io/terminal.h"

namespace merker::io {

struct TerminalAddress {
  Side side = Side::DigitalInput;
  std::uint32_t byte = 0, bit = 0;  // bit: of a digital one
};
std::optional<TerminalAddress> parseTerminalAddress(std::string_view text);
// Nothing: no signal connection lies there.
std::optional<Terminal> terminalAt(const Configuration& configuration,
                                   const TerminalAddress& address);

}  // namespace merker::io
