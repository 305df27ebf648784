// expect terminal MODULE.AO0 = 4mA: what an output puts out, or what lies at an input.
#pragma once

#include <string>

#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"
#include "scenario/terminal_value.h"
#include "station/station.h"

namespace merker::simulator::expectations {

struct Terminal {
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
  bool holds(station::Station& station) const {
    station.settle();
    return simulator::holds(terminal, relation, *station.rack());
  }
  std::string actual(station::Station& station) const {
    return terminal.text + " is " + actualValue(terminal, *station.rack());
  }
};

}  // namespace merker::simulator::expectations
