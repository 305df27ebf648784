// The declared variables of a running block with their values: parameters, static and temporary
// data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "address/reference.h"
#include "cpu/cpu.h"

namespace merker::monitor {

struct FrameVariable {
  std::string name;     // "pause", "list[2]", "motor.on"
  std::string section;  // IN, OUT, IN_OUT, RETURN, STAT, TEMP
  std::string type;
  // Nothing: a parameter that is no value (ANY, BLOCK_FC …), or its place cannot be reached.
  std::optional<std::string> value;
  // The same from outside, named "#pause", as long as the block stands; local data only of the
  // running block.
  std::optional<address::Reference> operand;
};

// Of the block `depth` steps below the running one (0 = the running block); composite variables
// and instances element by element, at most `most` rows. Empty if no such block runs.
std::vector<FrameVariable> frameVariables(const cpu::Cpu& cpu, std::size_t depth,
                                          std::size_t most = 256);

// An elementary variable of the running block by its name; nothing: its place cannot be reached.
std::optional<std::uint32_t> localBits(const cpu::Machine& machine, const std::string& name);

}  // namespace merker::monitor
