// Lengths of time as scenarios and the command line write them: 250ms, 7.5s, 2m, 1h, 1m30s,
// T#1S500MS, S5T#7S.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "clock/instant.h"

namespace merker::simulator {

// Nothing if `text` is no length of time, negative, or longer than 100 years.
std::optional<Duration> parseDuration(std::string_view text);

// Seconds with `decimals` digits after the point, cut off, never rounded: "7.350" for 7350 ms.
std::string formatSeconds(std::int64_t nanoseconds, int decimals);

// For messages: at least three decimals, further ones only where they are not 0.
std::string formatTime(Instant time);

}  // namespace merker::simulator
