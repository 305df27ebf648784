// Programs that are quiet most of the time, and look at time in every way that there is.
#pragma once

#include <cstdint>
#include <string>

namespace merker::differential {

// AWL of OB 1 and what it calls, of a few lines each.
std::string quietProgram(std::uint32_t seed);

}  // namespace merker::differential
