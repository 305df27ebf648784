// An outcome as the bytes that a process sends to the one that keeps the results.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "campaign/run.h"

namespace merker::campaign {

// Ends with a line feed; shorter than what a pipe takes at once (PIPE_BUF, 4096 bytes), so that it
// arrives whole or not at all.
std::string encode(std::uint64_t number, const Outcome& outcome);

struct Arrived {
  std::uint64_t number = 0;
  Outcome outcome;
};
// Without the line feed; nothing if it is no such line.
std::optional<Arrived> decode(std::string_view line);

}  // namespace merker::campaign
