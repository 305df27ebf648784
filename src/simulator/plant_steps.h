// Steps that drive plants: plant Oven.AMBIENT = 20, expect plant Oven.PV > 140.
#pragma once

#include <string>
#include <string_view>

#include "block/check.h"
#include "plant/plants.h"
#include "simulator/terminal_steps.h"

namespace merker::simulator {

struct PlantValue {
  std::string text;  // as written: "Oven.PV"
  Position position;
  std::string value;
  Position valuePosition;
  bool isSet = false;        // else looked at
  plant::SignalPlace place;  // after resolving, like `number`
  double number = 0;
};

bool parsePlant(std::string_view signal, std::string_view value, PlantValue& result,
                const PositionOf& at, Problems& problems);
// Whether there is such a plant and signal; null or empty without plants.
void resolve(PlantValue& value, const plant::Configuration* plants, Problems& problems);

void set(const PlantValue& value, plant::Plants& plants, io::Rack& rack, Instant now);
// ~= within a relative tolerance of 1e-6.
bool holds(const PlantValue& value, block::Relation relation, const plant::Plants& plants);
std::string actualValue(const PlantValue& value, const plant::Plants& plants);

}  // namespace merker::simulator
