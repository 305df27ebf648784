// The slot of the memory card.
#pragma once

#include "plc/capability.h"

namespace merker::controller {

class CardSlot : public Capability {
 public:
  static constexpr std::string_view kName = "slot for a memory card";

  // Pulled out and plugged in again: no start before a memory reset (S7-CPU-03).
  virtual void removeCard() = 0;
};

}  // namespace merker::controller
