// The ways from block to block between two pieces of compiled code: calls, block ends, A DB, with
// the effect and the time that they have in the processor (9.3.6).
#pragma once

#include <cstdint>
#include <optional>

#include "sinumerik/processor.h"

namespace merker::cnc {

struct Link {
  mc5::Operation operation;
  mc5::BlockId block;  // that is called or opened
  std::uint8_t words = 1;
  Duration time;
};

// Nothing if the instruction is none, or leads into a function macro.
std::optional<Link> linkAt(std::span<const std::uint16_t> code,
                           const sinumerik::Environment& environment);
// False: it is left to the processor, and nothing was done.
bool follow(const Link& link, sinumerik::Machine& m, sinumerik::Displays& displays);

}  // namespace merker::cnc
