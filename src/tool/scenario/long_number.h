// Whole numbers that no double word holds, where the language has no other notation for them.
#pragma once

#include <optional>
#include <string_view>

#include "base/problem.h"

namespace merker::simulator {

// P0955 for a whole number beyond 32 bits.
std::optional<Problem> beyondDoubleWord(std::string_view text, const Position& at);

}  // namespace merker::simulator
