// What a PLC keeps without power, as a memory card takes it and gives it back.
#pragma once

#include <vector>

#include "plc/capability.h"
#include "plc/retentive.h"

namespace merker::controller {

// How the program on a card differs from the one with which the PLC kept its data.
struct Renewal {
  bool anotherConfiguration = false;
  std::vector<BlockId> loaded, deleted;
};

class BufferedMemory : public Capability {
 public:
  static constexpr std::string_view kName = "memory that is kept without power";

  // As it is now. Calls cost little when little changed.
  virtual const block::RetentiveData& kept() = 0;
  // A new PLC goes on with this as after a power failure. False: it is not of such a PLC.
  virtual bool switchOn(const block::RetentiveData& data, const Renewal& renewal) = 0;
};

}  // namespace merker::controller
