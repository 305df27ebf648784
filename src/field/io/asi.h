// AS-Interface behind a CP 343-2 (S7-NET-17): up to 31 slaves, each with four bits in the CP's 16
// input and 16 output bytes. A slave is a module of its own, with terminals and faults.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/problem.h"
#include "io/configuration.h"

namespace merker::io {

constexpr std::uint32_t kHighestAsiAddress = 31, kAsiBits = 4;

// As merker.toml has it. The IO code, the first digit of the profile, says which of its data bits
// D0 to D3 are inputs and which outputs.
struct AsiSlave {
  std::uint32_t address = 1;
  std::string name, profile = "S-7.0";
  std::uint8_t ioCode = 7;
  Position position{};
};

bool isAsiMaster(const ModuleType& type);

// Of the slave `address`, in the CP's bytes: of the first one the upper half is the CP's own, then
// two slaves lie in each, the even address in the upper half (manual of the CP 343-2, 4.1.1).
constexpr std::uint32_t asiByte(std::uint32_t address) { return address / 2; }
constexpr std::uint32_t asiShift(std::uint32_t address) { return address % 2 == 0 ? 4 : 0; }

// Data bits that are inputs, or outputs; some are both.
std::uint8_t asiInputs(std::uint8_t ioCode);
std::uint8_t asiOutputs(std::uint8_t ioCode);

// Racks from this number on are AS-i subnets: so much more than the slot of the CP, and 100 for
// each rack in front of its own. Those of DP slaves lie behind.
constexpr std::uint32_t kAsiRack = 500;

// Adds the slaves of all CPs behind the modules of the racks.
void addAsiSlaves(Configuration& configuration, Problems& problems);

}  // namespace merker::io
