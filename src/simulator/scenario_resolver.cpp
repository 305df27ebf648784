// Binds the operands of scenarios to a program: once, before anything runs, so that all problems
// come out together.
#include "simulator/scenario.h"

namespace merker::simulator {
namespace {

// Whether the set bits of a constant have a place in the operand.
bool fits(const Constant& constant, const address::Reference& reference) {
  const unsigned width = bitWidth(reference);
  return width >= 32 || adapt(constant, reference.type).bits >> width == 0;
}

// Characters of a STRING; eight bytes of a DATE_AND_TIME always fit.
std::size_t longest(const address::Reference& reference) {
  if (reference.nc != 0) return SIZE_MAX;
  return reference.type == TypeCode::String ? reference.bytes - 2 : reference.bytes;
}

void resolveValues(Expectation& e, const Resolver& resolver, Problems& problems) {
  if (e.what != Expectation::What::Values) return;
  resolvePair(e.left, e.right, resolver, problems);
}

// A train of pulses would end with the next change of a plant that drives its terminal.
void checkDriver(const TerminalValue& terminal, const io::Configuration* hardware,
                 const plant::Configuration* plants, Problems& problems) {
  const io::Module* module = hardware == nullptr ? nullptr : hardware->find(terminal.module);
  if (module == nullptr || plants == nullptr) return;
  const auto index = static_cast<std::uint32_t>(module - hardware->modules.data());
  const std::string driver = plants->driverOf({index, terminal.side, terminal.channel});
  if (!driver.empty())
    problems.add(ProblemCode::P0988, terminal.position, terminal.text, "it is wired to " + driver);
}

void resolveSteps(std::vector<Step>& steps, const Resolver& resolver,
                  const io::Configuration* hardware, const plant::Configuration* plants,
                  Problems& problems) {
  for (Step& step : steps) {
    for (PlantValue& value : step.plants) resolve(value, plants, problems);
    if (step.kind == StepKind::Expect && step.expectation.what == Expectation::What::Plant)
      resolve(step.expectation.plant, plants, problems);
    if (step.kind == StepKind::Fault && !resolver.ofControl)
      resolve(step.fault, hardware, problems);
    resolve(step.signal, hardware, problems);
    for (TerminalValue& terminal : step.terminals) resolve(terminal, hardware, problems);
    for (const TerminalValue& terminal : step.signal.terminals)
      checkDriver(terminal, hardware, plants, problems);
    if (step.kind == StepKind::Expect && step.expectation.what == Expectation::What::Terminal)
      resolve(step.expectation.terminal, hardware, problems);
    for (Assignment& assignment : step.assignments) resolve(assignment, resolver, problems);
    if (step.kind == StepKind::Expect) resolveValues(step.expectation, resolver, problems);
    resolveSteps(step.body, resolver, hardware, plants, problems);
  }
}

}  // namespace

void resolve(Assignment& assignment, const Resolver& resolver, Problems& problems) {
  auto& [operand, value] = assignment;
  const std::size_t before = problems.size();
  resolvePair(operand, value, resolver, problems);
  if (problems.size() > before) return;
  if (operand.constant)
    problems.add(ProblemCode::P0904, operand.position, operand.text);
  else if (value.content && value.content->size() > longest(operand.reference))
    problems.add(ProblemCode::P0961, value.position, value.text, value.content->size(),
                 operand.text, longest(operand.reference));
  else if (value.constant && !fits(*value.constant, operand.reference))
    problems.add(ProblemCode::P0955, value.position, value.text, operand.text,
                 bitWidth(operand.reference));
}

void resolve(Scenario& scenario, const Resolver& resolver, Problems& problems,
             const io::Configuration* hardware, const plant::Configuration* plants) {
  resolveSteps(scenario.steps, resolver, hardware, plants, problems);
}

}  // namespace merker::simulator
