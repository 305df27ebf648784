// A PLC with a load memory beside its RAM: "Copy RAM to ROM" (S7-MEM-04).
#pragma once

#include <string>

#include "block/block.h"
#include "plc/capability.h"

namespace merker::cpu {

class RamToRom : public controller::Capability {
 public:
  static constexpr std::string_view kName = "load memory beside its RAM";

  // In STOP: the actual values of data blocks become those of load memory; program() then has them.
  // The reason why not, as text.
  virtual std::string copyRamToRom(std::string_view password) = 0;
  virtual const block::Program& program() const = 0;
};

}  // namespace merker::cpu
