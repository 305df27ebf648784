#include "workbench/held_bits.h"

#include <algorithm>

namespace merker::workbench {

void HeldBits::note(const std::vector<address::Reference>& written, bool held) {
  for (const address::Reference& one : written) {
    std::erase_if(bits_, [&](const address::Reference& bit) {
      return bit.operand == one.operand && bit.db == one.db;
    });
    const bool bit = address::isMemory(one.operand) && one.operand.width == Width::Bit;
    if (held && bit) bits_.push_back(one);
  }
}

// What is no longer there, or is forced meanwhile, stays as it is.
void HeldBits::release(monitor::Monitor& monitor) const {
  for (const address::Reference& bit : bits_) (void)monitor.write(bit.text, "0");
}

}  // namespace merker::workbench
