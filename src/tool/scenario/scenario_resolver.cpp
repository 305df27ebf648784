// Binds the steps of a scenario: each step does it for itself.
#include "scenario/scenario.h"

namespace merker::simulator {

void StepBinding::bind(std::vector<Step>& steps) const {
  for (Step& step : steps) std::visit([this](IsStep auto& one) { one.resolve(*this); }, step.does);
}

void resolve(Scenario& scenario, const Resolver& resolver, Problems& problems,
             const io::Configuration* hardware, const plant::Configuration* plants) {
  StepBinding{resolver, hardware, plants, problems}.bind(scenario.steps);
}

}  // namespace merker::simulator
