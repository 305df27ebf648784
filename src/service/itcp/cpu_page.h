// The page of the CPU, which each CP 343-1 IT has: it loads itself again every two seconds.
#pragma once

#include <string>

#include "itcp/cpu_facts.h"

namespace merker::itcp {

std::string cpuPage(const CpuFacts& facts);
// The same for scripts of the user's pages.
std::string cpuJson(const CpuFacts& facts);

}  // namespace merker::itcp
