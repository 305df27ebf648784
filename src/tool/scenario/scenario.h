// A scenario (*.scn) as values: steps in order (docs/formats/scenario.md).
#pragma once

#include <string>
#include <vector>

#include "scenario/step.h"
#include "source/source_file.h"

namespace merker::simulator {

struct Scenario {
  std::string name;
  Position position;
  std::vector<Step> steps;
};

// Reads all scenarios of a file; steps before the first `scenario` line form one named after the
// file. Lines with problems are left out.
std::vector<Scenario> parseScenarios(const source::SourceFile& file, Problems& problems);

// Binds all operands to the program, terminals and faults to the modules, signals to the plants,
// and checks that values fit. `hardware`: null without a hardware configuration.
void resolve(Scenario& scenario, const Resolver& resolver, Problems& problems,
             const io::Configuration* hardware = nullptr,
             const plant::Configuration* plants = nullptr);
// The same for several stations, at least one; the first is that of steps without `station`.
void resolve(Scenario& scenario, const std::vector<StationBinding>& stations, Problems& problems);

}  // namespace merker::simulator
