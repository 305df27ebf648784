// How much memory the loaded program takes (S7-CPU-02).
#pragma once

#include <cstdint>

#include "cpu/machine.h"

namespace merker::system {

struct MemoryUse {
  std::uint32_t work = 0, load = 0;  // bytes
};

// Work memory: machine code and values of data blocks; load memory: without those that SFC 22 made.
inline MemoryUse memoryUse(const cpu::Machine& m) {
  MemoryUse use;
  for (const auto* table : {&m.functions, &m.functionBlocks, &m.organizationBlocks})
    for (const cpu::Code* code : *table)
      if (code != nullptr) use.work += static_cast<std::uint32_t>(code->source->code.size());
  use.load = use.work;
  const auto highest = static_cast<std::uint32_t>(m.model->highestDb);
  for (std::uint32_t number = 1; number <= highest; ++number) {
    const cpu::DataBlock* block = m.dataBlocks.find(number);
    if (block == nullptr) continue;
    use.work += static_cast<std::uint32_t>(block->data.size());
    if (!block->madeByProgram) use.load += static_cast<std::uint32_t>(block->data.size());
  }
  return use;
}

}  // namespace merker::system
