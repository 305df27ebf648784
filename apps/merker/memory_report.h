// What a program takes of its CPU: load, work and system memory (S7-MEM-03), and how much of each
// resource is in use (S7-CPU-23).
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "build.h"

namespace merker::app {

struct Resource {
  std::string name, unit;
  std::size_t used = 0, available = 0;
  std::size_t percent() const { return available == 0 ? 0 : used * 100 / available; }
  // The course: 60 % to 80 % are good, above there is no reserve for more.
  bool noReserve() const { return used * 5 > available * 4; }
};

std::vector<Resource> resources(const Build& build);
void printMemory(const Build& build);
nlohmann::json memoryToJson(const Build& build);

}  // namespace merker::app
