// All operands of a PLC as bytes, at once: what is copied for readers that do not wait for it.
#pragma once

#include <cstdint>
#include <vector>

#include "plc/capability.h"

namespace merker::controller {

struct OperandImage {
  struct DataBlock {
    std::uint16_t number = 0;
    std::uint32_t begin = 0, octets = 0;  // in `data`
  };
  std::vector<std::uint8_t> inputs, outputs, flags;  // process images and flags
  std::vector<std::uint8_t> timers, counters;        // two bytes each, as LC loads them
  std::vector<std::uint8_t> data;
  std::vector<DataBlock> dataBlocks;  // ascending numbers
};

class OperandMemory : public Capability {
 public:
  static constexpr std::string_view kName = "operands that can be copied";

  // As they are now; `image` keeps its memory from copy to copy.
  virtual void copyOperands(OperandImage& image) const = 0;
};

}  // namespace merker::controller
