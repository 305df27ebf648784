// expect diagnostics contains "text": an entry of the diagnostic buffer contains it.
#pragma once

#include <string>

#include "plc/controller.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"

namespace merker::simulator::expectations {

struct Diagnostics {
  static constexpr bool kSpeaksOfState = true;
  std::string words;

  bool parse(const StepLine& line, const Claim& claim);
  void resolve(const StepBinding&) {}
  bool holds(controller::Controller& plc) const;
  std::string actual(controller::Controller& plc) const;
};

}  // namespace merker::simulator::expectations
