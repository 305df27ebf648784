// What the operating system checks before it starts: machine data, memory, periphery, blocks
// (6100, 6105, 6116 … 6143, S5-ERR-19, S5-MEM-10).
#pragma once

#include <map>
#include <optional>

#include "softplc/machine.h"
#include "softplc/options.h"
#include "softplc/trap.h"

namespace merker::sinumerik {

// Sums of the code blocks as they were loaded; a block that changed since fails (6136).
class Checksums {
 public:
  void take(const BlockMemory& blocks);
  std::optional<mc5::BlockId> changed(const BlockMemory& blocks) const;

 private:
  std::map<mc5::BlockId, std::uint16_t> sums_;
};

struct StartFault {
  Trap trap;
  ControlBit also = ControlBit::NONE;  // beside the alarm's own bit
};

// The first fault, in the order of the start-up. Builds the block lists and the system's DBs.
std::optional<StartFault> checkStart(Machine& machine, const Options& options,
                                     const MachineData& data, const Surroundings& around,
                                     const Checksums& sums);

}  // namespace merker::sinumerik
