// What happens to one character on its way, on purpose (PTP-LINE-09).
#pragma once

#include <cstdint>
#include <optional>

#include "serial/frame.h"

namespace merker::serial {

struct Fault {
  enum class Kind : std::uint8_t {
    Drop,       // it takes its time, but is not on the line
    Duplicate,  // twice
    Flip,       // the bits of `pattern` in the frame are inverted; bit 0 is the start bit
    Replace,    // another character: `pattern`
    Insert,     // the character `pattern` in front of it
    Parity,     // wrong parity bit
    Stop,       // stop bit 0: a frame fault
    Overrun,    // the receiver loses a character
    Delay       // starts later by `delay`
  };
  Kind kind = Kind::Flip;
  std::uint16_t pattern = 0;
  Duration delay{};
};

// What is then on the line: bit patterns, one after the other.
struct Emission {
  std::optional<std::uint16_t> before, character;
  Duration delay{};
  bool overrun = false;
};

Emission plain(const Frame& frame, std::uint8_t value);
Emission disturbed(const Frame& frame, std::uint8_t value, const Fault& fault);

}  // namespace merker::serial
