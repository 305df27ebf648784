// How much of its CPU a program uses (S7-CPU-23).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "block/block.h"
#include "catalogue/cpu_model.h"
#include "io/configuration.h"

namespace merker::project {

struct Usage {
  std::string_view resource;  // "work memory"
  std::string_view unit;      // "bytes"
  std::uint32_t used = 0, possible = 0;
  unsigned percent() const {
    return possible == 0 ? 0 : static_cast<unsigned>(std::uint64_t{used} * 100 / possible);
  }
  // The course wants a CPU to be used by 60 to 80 %.
  bool withoutReserve() const { return percent() > 80; }
};

// Work memory, timers and counters of the program, channels of the hardware.
std::vector<Usage> usage(const block::Program& program, const CpuModel& model,
                         const std::optional<io::Configuration>& hardware);

}  // namespace merker::project
