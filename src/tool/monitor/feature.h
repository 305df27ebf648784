// What a machine can do for those who test it. The command line and the page ask for it, never for
// the family.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace merker::monitor {

enum class Feature : std::uint8_t {
  Breakpoints,   // hold before a statement, single steps, program status
  CyclePoints,   // variable tables at trigger points
  Stacks,        // B, I and L stack
  Information,   // module information
  Blocks,        // the list of blocks, their machine code
  Download,      // blocks one by one, also in RUN: load, compare, upload, delete
  Completion,    // suggestions while a source is written
  References,    // cross reference
  Symbols,       // a symbol table that can be edited
  Rack,          // modules with their terminals
  Plants,        // machines and processes at the terminals
  Interrupts,    // organization blocks by hand
  Engine,        // machine code of this computer by choice
  Snapshots,     // the whole state in a file
  TimersByHand,  // S5 timers stand until someone sets them
  ModeSwitch,    // RUN-P, RUN, STOP, MRES
  Leds,
  Clock,  // date and time of day that can be set
  Nc      // data of a numerical control beside it
};

struct FeatureName {
  Feature feature;
  std::string_view name;  // as the protocol of the workbench has it
  std::string_view what;  // completes "this PLC has no ..."
};

// In the order of the enumeration.
std::span<const FeatureName> features();
std::string_view name(Feature feature);
std::string_view what(Feature feature);

}  // namespace merker::monitor
