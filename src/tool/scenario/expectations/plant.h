// expect plant NAME.SIGNAL > VALUE: an input or output of a plant.
#pragma once

#include <optional>
#include <string>

#include "plant/field.h"
#include "scenario/claim.h"
#include "scenario/plant_value.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"

namespace merker::simulator::expectations {

struct Plant {
  using Needs = plant::Field;
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
  bool holds(controller::Controller& plc) const {
    return simulator::holds(signal, relation, plantsOf(plc));
  }
  // The next step of a plant.
  std::optional<Instant> staysUntil(const controller::Controller& plc) const {
    return plantsOf(plc).next();
  }
  std::string actual(controller::Controller& plc) const {
    return signal.text + " is " + actualValue(signal, plantsOf(plc));
  }

 private:
  static const plant::Plants& plantsOf(const controller::Controller& plc) {
    return *controller::capability<plant::Field>(plc)->plants();
  }
};

}  // namespace merker::simulator::expectations
