// Text from outside as it may be shown.
#pragma once

#include <string>
#include <string_view>

namespace merker {

// Control characters as \x1B: they would upset a terminal, or make lines of their own.
std::string visible(std::string_view utf8);

}  // namespace merker
