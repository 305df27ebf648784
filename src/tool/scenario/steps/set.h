// set OPERAND = VALUE, …; force OPERAND = VALUE, …; unforce.
#pragma once

#include <string>
#include <vector>

#include "scenario/assignment.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

// What lies at a terminal does not need the CPU; its memory does.
inline bool isTerminal(const address::Reference& reference) {
  const Area area = reference.operand.area;
  return reference.operand.kind == address::OperandKind::Memory &&
         (area == Area::Input || area == Area::Peripheral) && !reference.outputSide;
}

template <bool force>
struct Assigns {
  static constexpr std::string_view kWords = force ? "force" : "set";

  std::vector<Assignment> assignments;

  bool parse(const StepLine& line) {
    assignments = parseAssignments(line);
    return !assignments.empty();
  }
  void resolve(const StepBinding& binding) {
    for (Assignment& one : assignments) simulator::resolve(one, binding.resolver, binding.problems);
  }
  bool perform(StepRun& run) const {
    ForceList here;  // of this step: no bit twice
    for (const Assignment& one : assignments) {
      const address::Reference& operand = one.operand.reference;
      const bool unpowered = !force && isTerminal(operand);
      if (!unpowered && !run.powered(operand)) return false;
      std::string reason =
          force ? run.forces().whyNotForced(operand) : run.forces().whyNotSet(operand);
      if (force && reason.empty()) reason = here.whyNotTwice(operand);
      if (reason.empty()) reason = apply(one, force, run.plc());
      if (!reason.empty()) return run.failAt(one.operand.position, reason);
      if (force) here.add(operand);
      if (force) run.forces().add(operand);
    }
    return true;
  }
};
using Set = Assigns<false>;
using Force = Assigns<true>;

struct Unforce : Bare {
  static constexpr std::string_view kWords = "unforce";

  bool perform(StepRun& run) const {
    if (!run.powered()) return false;
    run.plc().unforce();
    run.clearForces();
    return true;
  }
};

}  // namespace merker::simulator::steps
