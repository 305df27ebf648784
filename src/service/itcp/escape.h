// Texts inside a page.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace merker::itcp {

// What a value must not break out of. None: such a file has no values, it is sent as it is.
enum class Escape : std::uint8_t { None, Html, Json };

// Control characters become blanks.
std::string escaped(std::string_view text, Escape how);

}  // namespace merker::itcp
