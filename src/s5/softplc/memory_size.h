// How large the segments of a PLC are and where it shows them (S5-MEM-T1, S5-MEM-07, -08).
#pragma once

#include <cstdint>

#include "mc5/block.h"
#include "softplc/machine.h"
#include "softplc/options.h"

namespace merker::sinumerik {

struct MemorySize {
  std::uint32_t programWords, dataWords;  // user data only
};

bool hasExtension(const Options& options);
MemorySize memorySize(const Options& options, const MachineData& data);
// Segment addresses and unit of the offsets in the block lists.
Layout layoutOf(const Options& options, const MachineData& data);
// What the block directory of the programmer adds to the offset of a block.
std::uint32_t directoryOffset(const Options& options, const MachineData& data, mc5::BlockType type,
                              bool resident);

}  // namespace merker::sinumerik
