// expect ustack SAZ = 002A, expect bstack 1 = PB 5: what a programmer shows of a STOP.
#pragma once

#include <string>

#include "plc/controller.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"

namespace merker::simulator::expectations {

struct Stack {
  static constexpr bool kSpeaksOfState = true;
  std::string stack, name, value;  // "USTACK", "SAZ", "002A"
  block::Relation relation = block::Relation::Equal;

  bool parse(const StepLine& line, const Claim& claim);
  void resolve(const StepBinding&) {}
  // Values are hexadecimal digits, with or without KH, or names of blocks.
  bool holds(controller::Controller& plc) const;
  // "SAZ is 0030", or why nothing is there to see.
  std::string actual(controller::Controller& plc) const;
};

}  // namespace merker::simulator::expectations
