// The declared variables of a running block with their values: parameters, static and temporary
// data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpu/cpu.h"

namespace merker::monitor {

struct FrameVariable {
  std::string name;     // "pause", "list[2]", "motor.on"
  std::string section;  // IN, OUT, IN_OUT, RETURN, STAT, TEMP
  std::string type;
  std::optional<std::string> value;  // nothing: not elementary, or its place cannot be reached
};

// Of the block `depth` steps below the running one (0 = the running block); composite variables
// element by element, at most 256 rows. Empty if no such block runs.
std::vector<FrameVariable> frameVariables(const cpu::Cpu& cpu, std::size_t depth);

}  // namespace merker::monitor
