// plant NAME.INPUT = VALUE, …; plant NAME.SIGNAL stuck VALUE; … free; plant NAME reset.
#pragma once

#include <string_view>
#include <vector>

#include "plant/field.h"
#include "scenario/plant_value.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct Plant {
  static constexpr std::string_view kWords = "plant";

  std::vector<PlantValue> values;

  bool parse(const StepLine& line) {
    for (const std::string_view part : splitList(line.rest()))
      if (!parsePlantStep(part, values.emplace_back(), line.positions(), line.problems()))
        return false;
    return true;
  }
  void resolve(const StepBinding& binding) {
    for (PlantValue& value : values) simulator::resolve(value, binding.plants, binding.problems);
  }
  bool perform(StepRun& run) const {
    auto* const field = run.need<plant::Field>();
    if (field == nullptr) return false;
    for (const PlantValue& value : values)
      apply(value, *field->plants(), *field->rack(), run.plc().now());
    return true;
  }
};

}  // namespace merker::simulator::steps
