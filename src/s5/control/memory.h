// How much of its memory a program takes (S5-MEM-08, S5-SCHED-13, S5-DB-16).
#pragma once

#include <vector>

#include "control/cnc.h"

namespace merker::cnc {

// One of the segments 5 and 6, in words; blocks count with their headers.
struct SegmentUse {
  std::uint32_t used = 0, size = 0;
};

// A block that the PLC would not load.
struct NoRoom {
  mc5::BlockId block;
  std::uint32_t words = 0;
  SegmentUse segment;  // what the blocks before it take
};

struct MemoryUse {
  SegmentUse program, data;  // of user data only
  std::vector<NoRoom> missing;
};

// What the blocks of options.plc.program take, loaded in their order.
MemoryUse memoryUse(const Options& options);

}  // namespace merker::cnc
