#include "scenario/runner.h"

#include "scenario/start.h"
#include "scenario/state_text.h"
#include "scenario/step_run.h"

namespace merker::simulator {

using controller::Controller;
using controller::Mode;

TestResult runScenario(const Scenario& scenario, Controller& plc) {
  TestResult result{scenario.position.file, scenario.name, {}, {}};
  const auto fail = [&](const Position& position, const std::string& message) {
    result.failures.push_back({position, plc.now(), message});
  };
  StepRun run(plc, result);
  const std::string reason = refusal(plc);
  // A fault that ends the start is a state that a scenario may expect; a refused start is not.
  const bool refused = !reason.empty() && !plc.stoppedByFault();
  if (refused) fail(scenario.position, reason);
  if (!refused && run.run(scenario.steps) && plc.stoppedByFault() && !run.speaksOfState())
    fail(scenario.steps.empty() ? scenario.position : scenario.steps.back().position,
         "expected no fault, the CPU went to STOP: " + stopText(plc));
  result.end = plc.now();
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
