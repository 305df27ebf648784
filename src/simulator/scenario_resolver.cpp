// Binds the operands of scenarios to a program: once, before anything runs, so that all problems
// come out together.
#include "simulator/scenario.h"

namespace merker::simulator {
namespace {

// Whether the set bits of a constant have a place in the operand.
bool fits(const Constant& constant, const mc7::Reference& reference) {
  const unsigned width = bitWidth(reference);
  return width >= 32 || adapt(constant, reference.type).bits >> width == 0;
}

void resolveValues(Expectation& e, const Resolver& resolver, Problems& problems) {
  if (e.what != Expectation::What::Values) return;
  if (auto problem = resolveTerm(e.left, resolver)) problems.add(*problem);
  if (auto problem = resolveTerm(e.right, resolver)) problems.add(*problem);
}

void resolveSteps(std::vector<Step>& steps, const Resolver& resolver, Problems& problems) {
  for (Step& step : steps) {
    for (Assignment& assignment : step.assignments)
      if (auto problem = resolve(assignment, resolver)) problems.add(*problem);
    if (step.kind == StepKind::Expect) resolveValues(step.expectation, resolver, problems);
    resolveSteps(step.body, resolver, problems);
  }
}

}  // namespace

std::optional<Problem> resolve(Assignment& assignment, const Resolver& resolver) {
  auto& [operand, value] = assignment;
  if (auto problem = resolveOperand(operand, resolver)) return problem;
  if (auto problem = resolveTerm(value, resolver)) return problem;
  if (!value.constant || fits(*value.constant, operand.reference)) return std::nullopt;
  return makeProblem(ProblemCode::P0955, value.position, value.text, operand.text,
                     bitWidth(operand.reference));
}

void resolve(Scenario& scenario, const Resolver& resolver, Problems& problems) {
  resolveSteps(scenario.steps, resolver, problems);
}

}  // namespace merker::simulator
