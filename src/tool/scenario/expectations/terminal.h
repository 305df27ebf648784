// expect terminal MODULE.AO0 = 4mA: what an output puts out, or what lies at an input.
#pragma once

#include <string>

#include "plant/field.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"
#include "scenario/terminal_value.h"

namespace merker::simulator::expectations {

struct Terminal {
  using Needs = plant::Field;
  static constexpr bool kSpeaksOfState = false;
  TerminalValue terminal;
  block::Relation relation = block::Relation::Equal;

  bool parse(const StepLine& line, const Claim& claim) {
    relation = claim.relation;
    return parseTerminal(claim.subject, claim.value, terminal, line.positions(), line.problems());
  }
  void resolve(const StepBinding& binding) {
    simulator::resolve(terminal, binding.hardware, binding.problems);
  }
  bool holds(controller::Controller& plc) const {
    plc.settle();
    return simulator::holds(terminal, relation, rackOf(plc));
  }
  std::string actual(controller::Controller& plc) const {
    return terminal.text + " is " + actualValue(terminal, rackOf(plc));
  }

 private:
  static const io::Rack& rackOf(controller::Controller& plc) {
    return *controller::capability<plant::Field>(plc)->rack();
  }
};

}  // namespace merker::simulator::expectations
