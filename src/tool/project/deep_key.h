// Keys of merker.toml within each other (a.b.c): the TOML library makes a table of each and goes
// down into them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace merker::project {

constexpr std::size_t kDeepestKey = 32;

// Where a key has more parts than that.
std::optional<std::size_t> deepKey(std::string_view toml);

}  // namespace merker::project
