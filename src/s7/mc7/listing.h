// A block's code as the processor goes through it: the instructions one behind the other, without
// the parameter lists that calls jump over. Every engine counts the instructions of a block this
// way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mc7/instruction.h"

namespace merker::mc7 {

struct Place {
  std::uint32_t offset = 0;  // bytes
  bool known = false;        // false: no row fits
  Instruction instruction;
  // UC or CC with a list behind it (MC7 section 7.2): entries of Listing::parameters
  std::uint32_t firstParameter = 0;
  std::uint16_t parameters = 0;
};

struct Listing {
  std::vector<Place> places;
  std::vector<std::uint32_t> parameters;  // pointers, of all calls one behind the other
  // By word of the code: the number of the instruction that begins there, -1 inside one or inside a
  // list. The end of the code is one more place.
  std::vector<std::int32_t> placeAt;
  // Of the jump at `place`: the instruction it leads to, -1 if none begins there.
  std::int32_t target(const Place& place) const;
};

// Any bytes are welcome.
Listing list(std::span<const std::uint8_t> code);

}  // namespace merker::mc7
