// expect plant NAME.SIGNAL > VALUE: an input or output of a plant.
#pragma once

#include <string>

#include "scenario/claim.h"
#include "scenario/plant_value.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"
#include "station/station.h"

namespace merker::simulator::expectations {

struct Plant {
  static constexpr bool kSpeaksOfState = false;
  PlantValue signal;
  block::Relation relation = block::Relation::Equal;

  bool parse(const StepLine& line, const Claim& claim) {
    relation = claim.relation;
    return parsePlant(claim.subject, claim.value, signal, line.positions(), line.problems());
  }
  void resolve(const StepBinding& binding) {
    simulator::resolve(signal, binding.plants, binding.problems);
  }
  bool holds(station::Station& station) const {
    return simulator::holds(signal, relation, *station.plants());
  }
  std::string actual(station::Station& station) const {
    return signal.text + " is " + actualValue(signal, *station.plants());
  }
};

}  // namespace merker::simulator::expectations
