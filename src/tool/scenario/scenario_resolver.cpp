// Binds the steps of a scenario: each step does it for itself.
#include "base/text.h"
#include "scenario/scenario.h"

namespace merker::simulator {

StepBinding StepBinding::of(std::size_t number) const {
  const StationBinding& one = (*stations)[number];
  return {one.resolver, one.hardware, one.plants, problems, stations, number};
}

// Nothing, and a problem, if there is no such station.
std::optional<std::size_t> StepBinding::find(const steps::Station& wanted) const {
  std::string names;
  for (std::size_t i = 0; stations != nullptr && i < stations->size(); ++i) {
    if (equalsIgnoreCase((*stations)[i].name, wanted.name)) return i;
    names += (i == 0 ? "" : ", ") + (*stations)[i].name;
  }
  problems.add(ProblemCode::P0704, wanted.position, wanted.name,
               stations == nullptr ? "left out with its step: the project has one station only"
                                   : "the name of a [[station]]: " + names);
  return std::nullopt;
}

void StepBinding::bind(std::vector<Step>& steps) const {
  std::size_t now = station;
  for (Step& step : steps) {
    if (const auto* const chosen = std::get_if<steps::Station>(&step.does))
      now = find(*chosen).value_or(now);
    step.station = now;
    const StepBinding own = stations == nullptr ? *this : of(now);
    std::visit([&own](IsStep auto& one) { one.resolve(own); }, step.does);
  }
}

void resolve(Scenario& scenario, const Resolver& resolver, Problems& problems,
             const io::Configuration* hardware, const plant::Configuration* plants) {
  StepBinding{resolver, hardware, plants, problems}.bind(scenario.steps);
}

void resolve(Scenario& scenario, const std::vector<StationBinding>& stations, Problems& problems) {
  const StationBinding& first = stations.front();
  StepBinding{first.resolver, first.hardware, first.plants, problems, &stations}.bind(
      scenario.steps);
}

}  // namespace merker::simulator
