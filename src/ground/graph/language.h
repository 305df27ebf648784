// The languages in which networks are named, said and refused.
#pragma once

#include <cstdint>

namespace merker::graph {

enum class Language : std::uint8_t { German, English };

}  // namespace merker::graph
