// What a parameter of a campaign changes, by its name: a parameter or an input of a plant, an
// operand of the program, the CPU, the engine, the scenario.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "campaign/definition.h"
#include "compilation/build.h"
#include "scenario/assignment.h"
#include "scenario/plant_value.h"

namespace merker::campaign {

// plant.Vessel.stroke: a key of its [[plant]].
struct PlantParameter {
  std::uint32_t plant = 0, parameter = 0;
};
// plant.Vessel.HAND_FILL: an input that nothing drives, set at the beginning of a run.
struct PlantInput {
  simulator::PlantValue signal;
};
// set.MW 10: set at the beginning of a run.
struct Operand {
  simulator::Assignment assignment;
  bool real = false;   // its values are REAL numbers, also whole ones
  bool drawn = false;  // of values that are not REAL the whole number beside it
};
struct CpuModelName {};  // cpu.model
struct Engine {};        // cpu.engine
struct ScenarioFile {};  // scenario.file
struct ScenarioName {};  // scenario.name
using Target = std::variant<PlantParameter, PlantInput, Operand, CpuModelName, Engine, ScenarioFile,
                            ScenarioName>;

// Whether it acts only where a run begins: the PLC may have come there before the value is known.
bool actsLate(const Target& target);

// Nothing, and a problem at each place that is wrong: the name, or values that it cannot take.
std::optional<Target> bindTarget(const Parameter& parameter, const compilation::Build& build,
                                 Problems& problems);
// The number that a text means to the parameter of a plant: "20s", "true", "0.8"; nothing if it
// cannot be.
std::optional<double> plantNumber(const plant::Parameter& parameter, const Value& value);

// The same target with this value, as it is applied; problems as for `set` of a scenario.
simulator::PlantValue withValue(const PlantInput& input, const Value& value, const Position& place);
std::optional<simulator::Assignment> withValue(const Operand& operand, const Value& value,
                                               const Position& place,
                                               const simulator::Resolver& resolver,
                                               Problems& problems);

}  // namespace merker::campaign
