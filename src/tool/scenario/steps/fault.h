// fault MODULE KIND [channel N] [off]: something is wrong with a module from now on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "io/rack.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct Fault {
  static constexpr std::string_view kWords = "fault";
  static constexpr bool kPartner = true;

  std::string module;
  Position position;  // of the module's name
  std::string words;  // the fault as written
  Position wordsPosition;
  io::FaultKind kind = io::FaultKind::Defect;  // of a SIMATIC S7: after resolving
  std::optional<std::uint32_t> channel;
  bool there = true;

  bool parse(const StepLine& line);
  // A PLC without modules, as a SINUMERIK, judges its faults itself, when they come.
  void resolve(const StepBinding& binding);
  bool perform(StepRun& run) const;
};

}  // namespace merker::simulator::steps
