// expect mode = RUN: RUN, STOP, STARTUP or HALT.
#pragma once

#include <string>

#include "base/text.h"
#include "plc/controller.h"
#include "scenario/claim.h"
#include "scenario/state_text.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"

namespace merker::simulator::expectations {

struct Mode {
  static constexpr bool kSpeaksOfState = true;
  controller::Mode mode = controller::Mode::Run;
  block::Relation relation = block::Relation::Equal;  // or NotEqual

  bool parse(const StepLine& line, const Claim& claim) {
    relation = claim.relation;
    if (!claim.comparesEqual() || !claim.subject.empty())
      return line.fail(ProblemCode::P0952, claim.whole, "mode = or mode <>");
    using controller::Mode;
    for (const auto one : {Mode::Run, Mode::Stop, Mode::Startup, Mode::Halt}) {
      if (!equalsIgnoreCase(claim.value, modeName(one))) continue;
      mode = one;
      return true;
    }
    return line.fail(ProblemCode::P0954, claim.value.empty() ? claim.whole : claim.value,
                     claim.value);
  }
  void resolve(const StepBinding&) {}
  static Instant staysUntil(const controller::Controller&) { return Instant::never(); }
  bool holds(controller::Controller& plc) const { return agrees(plc.mode() == mode, relation); }
  std::string actual(controller::Controller& plc) const {
    return "mode is " + std::string(modeName(plc.mode())) + because(plc);
  }
};

}  // namespace merker::simulator::expectations
