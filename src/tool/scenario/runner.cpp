#include "scenario/runner.h"

#include "scenario/start.h"
#include "scenario/state_text.h"
#include "scenario/step_run.h"

namespace merker::simulator {

using controller::Controller;
using controller::Mode;

namespace {

// "the CPU", "the CPU of Press"
std::string cpuOf(const NamedPlc& plc) {
  return plc.name.empty() ? "the CPU" : "the CPU of " + plc.name;
}

}  // namespace

TestResult runScenario(const Scenario& scenario, Controller& plc) {
  return runScenario(scenario, {NamedPlc{{}, &plc}});
}

TestResult runScenario(const Scenario& scenario, const std::vector<NamedPlc>& plcs,
                       const Begun& begun) {
  TestResult result{scenario.position.file, scenario.name, {}, {}};
  const auto fail = [&](const NamedPlc& plc, const Position& position, const std::string& message) {
    result.failures.push_back({position, plc.plc->now(), message});
  };
  StepRun run(plcs, result);
  const std::vector<std::string> reasons = refusals(plcs);
  // A fault that ends the start is a state that a scenario may expect; a refused start is not.
  for (std::size_t i = 0; i < plcs.size(); ++i)
    if (!reasons[i].empty() && !plcs[i].plc->stoppedByFault())
      fail(plcs[i], scenario.position,
           (plcs[i].name.empty() ? "" : plcs[i].name + ": ") + reasons[i]);
  if (result.passed() && begun)
    if (const std::string reason = begun(); !reason.empty())
      fail(plcs.front(), scenario.position, reason);
  const bool done = result.passed() && run.run(scenario.steps);
  for (std::size_t i = 0; done && i < plcs.size(); ++i)
    if (plcs[i].plc->stoppedByFault() && !run.speaksOfState(i))
      fail(plcs[i], scenario.steps.empty() ? scenario.position : scenario.steps.back().position,
           "expected no fault, " + cpuOf(plcs[i]) + " went to STOP: " + stopText(*plcs[i].plc));
  result.end = plcs.front().plc->now();
  return result;
}

TestResult runUntil(const Scenario& scenario, const Until& until, Controller& plc) {
  TestResult result{scenario.position.file, scenario.name, {}, {}};
  const std::string reason = refusal(plc);
  if (!reason.empty()) result.failures.push_back({scenario.position, plc.now(), reason});
  const bool ended = plc.mode() == Mode::Stop && until.line == 0;
  if (reason.empty() && !ended) (void)StepRun(plc, result, &until).run(scenario.steps);
  result.end = plc.now();
  return result;
}

}  // namespace merker::simulator
