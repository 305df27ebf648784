// expect MW 10 < 5: operands and constants.
#pragma once

#include <optional>
#include <string>

#include "plc/controller.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"

namespace merker::simulator::expectations {

struct Values {
  static constexpr bool kSpeaksOfState = false;
  Term left, right;
  block::Relation relation = block::Relation::Equal;

  bool parse(const StepLine& line, const Claim& claim) {
    relation = claim.relation;
    return line.term(left, claim.subject, claim.whole, "an operand") &&
           line.term(right, claim.value, claim.whole, "a value");
  }
  void resolve(const StepBinding& binding) {
    resolvePair(left, right, binding.resolver, binding.problems);
  }
  std::optional<Instant> staysUntil(const controller::Controller& plc) const;
  bool holds(controller::Controller& plc) const;
  std::string actual(controller::Controller& plc) const;
};

}  // namespace merker::simulator::expectations
