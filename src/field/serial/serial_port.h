// A PLC with a serial interface, for scenarios, monitors and connections to the outside.
#pragma once

#include "plc/capability.h"

namespace merker::serial {

class Coupling;

class SerialPort : public controller::Capability {
 public:
  static constexpr std::string_view kName = "serial interface";

  // At the PLC's own time; null: the project has no such sub-module.
  virtual Coupling* serial() = 0;
};

}  // namespace merker::serial
