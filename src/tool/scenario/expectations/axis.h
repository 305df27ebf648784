// expect axis.NAME > VALUE: the positioning channel, without a program that shows it.
#pragma once

#include <string>

#include "scenario/axis_term.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"

namespace merker::simulator::expectations {

struct Axis {
  using Needs = positioning::AxisOwner;
  static constexpr bool kSpeaksOfState = false;
  AxisTerm term;
  block::Relation relation = block::Relation::Equal;

  bool parse(const StepLine& line, const Claim& claim) {
    relation = claim.relation;
    return parseAxis(claim.subject, claim.value, term, line.positions(), line.problems());
  }
  void resolve(const StepBinding& binding) {
    simulator::resolve(term, binding.hardware, binding.problems);
  }
  bool holds(controller::Controller& plc) const {
    return simulator::holds(term, relation, axisOf(plc));
  }
  std::string actual(controller::Controller& plc) const {
    return term.text + " is " + actualValue(term, axisOf(plc));
  }
};

}  // namespace merker::simulator::expectations
