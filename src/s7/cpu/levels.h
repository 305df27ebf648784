// Priority classes: an OB of a higher class interrupts at an instruction boundary; registers are
// saved and begin at zero (S7-REG-05, -06). The stacks are those of the machine.
#pragma once

#include <cstdint>

#include "cpu/machine.h"
#include "cpu/start_information.h"

namespace merker::cpu {

inline bool hasOb(const Machine& m, std::uint32_t number) {
  return find(m.organizationBlocks, number) != nullptr;
}
// Of the running OB; 0 if none runs.
inline std::uint8_t runningPriority(const Machine& m) {
  return m.levels.empty() ? std::uint8_t{0} : m.levels.back().priority;
}
inline std::uint8_t runningOb(const Machine& m) {
  return m.levels.empty() ? std::uint8_t{0} : m.levels.back().ob;
}

// An OB that is loaded begins. An error OB (OB 121, OB 122) belongs to the class that it
// interrupts. False: no room in a stack, the CPU has gone to STOP.
bool startLevel(Machine& m, std::uint8_t ob, std::uint8_t priority, const StartInformation& start,
                bool errorOb);
// The OB on top has ended: what it had interrupted is restored. Returns the ended level.
Level endLevel(Machine& m);
// Nothing runs and nothing is interrupted any more.
void clearStacks(Machine& m);

}  // namespace merker::cpu
