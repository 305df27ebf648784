// Where a variable table monitors and modifies: before OB 1 with fresh inputs, behind OB 1 before
// the outputs go out, at the transition to STOP.
#pragma once

#include <cstdint>

namespace merker::monitor {

enum class CyclePoint : std::uint8_t { Begin, End, Stop };

}  // namespace merker::monitor
