// What lies before the terminals of a PLC, of one that has modules: their rack and the plants that
// are wired to it.
#pragma once

#include "io/rack.h"
#include "plant/plants.h"
#include "plc/capability.h"

namespace merker::plant {

class Field : public controller::Capability {
 public:
  static constexpr std::string_view kName = "modules with terminals";

  // At the PLC's own time; null without a hardware configuration. Changes reach the CPU at its next
  // instruction boundary.
  virtual io::Rack* rack() = 0;
  virtual const io::Rack* rack() const = 0;
  // Moved by the PLC's time; null without a hardware configuration.
  virtual Plants* plants() = 0;
  virtual const Plants* plants() const = 0;
};

}  // namespace merker::plant
