// Faults that can happen to a module and what its diagnostic data say of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "catalogue/module_type.h"

namespace merker::io {

enum class FaultKind : std::uint8_t {
  WireBreak,     // analog inputs and outputs, digital outputs with diagnosis
  ShortCircuit,  // outputs to M
  Overflow,      // analog inputs, by the value
  Underflow,
  LoadVoltage,     // L+ is missing: inputs show 0 or 32767, outputs put out nothing
  SensorSupply,    // of a digital input module
  Fuse,            // of a digital output module
  Defect,          // the module itself: inner fault
  Removed,         // pulled out of the rack
  RackPower,       // an IM without supply: its rack fails
  ParameterError,  // of the sub-modules 2.4 and 2.5: they do not work with their parameters
  InterruptLost,   // of the sub-module 2.4: a hardware interrupt came again too early
  LineBreak        // of the sub-module 2.1: BREAK on its receive line
};

struct FaultName {
  std::string_view words;  // "wire break", as `fault MODULE KIND` takes it
  FaultKind kind;
  bool channel;  // of one channel; else of the whole module
};

const FaultName* findFault(std::string_view words);
const FaultName& nameOf(FaultKind kind);
std::string faultNames();  // for problems
// Whether a module of this type can have it.
bool possible(const ModuleType& type, FaultKind kind);

}  // namespace merker::io
