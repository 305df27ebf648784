// Bits that a browser holds at 1 as a finger holds a push button: they are 0 again when it has
// gone.
#pragma once

#include <vector>

#include "monitor/monitor.h"

namespace merker::workbench {

class HeldBits {
 public:
  std::size_t size() const { return bits_.size(); }
  // They are written: from now on held, or no longer. What is no bit keeps its value.
  void note(const std::vector<address::Reference>& written, bool held);
  void release(monitor::Monitor& monitor) const;

 private:
  std::vector<address::Reference> bits_;
};

}  // namespace merker::workbench
