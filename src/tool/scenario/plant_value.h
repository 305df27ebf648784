// A signal of a plant and what happens to it: Oven.AMBIENT = 20, Oven.PV stuck 80, Oven reset, or
// the value that it should have.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "check/check.h"
#include "plant/plants.h"
#include "scenario/line.h"

namespace merker::simulator {

struct PlantValue {
  enum class Does : std::uint8_t { Look, Set, Stick, StickAsItIs, Release, Reset };
  Does does = Does::Look;
  std::string text;  // as written: "Oven.PV"
  Position position;
  std::string value;
  Position valuePosition;
  plant::SignalPlace place;  // after resolving, like `number`
  double number = 0;
};

// Of `expect`.
bool parsePlant(std::string_view signal, std::string_view value, PlantValue& result,
                const PositionOf& at, Problems& problems);
// One part of a step: "Oven.AMBIENT = 20".
bool parsePlantStep(std::string_view part, PlantValue& result, const PositionOf& at,
                    Problems& problems);
// Whether there is such a plant and signal; null or empty without plants.
void resolve(PlantValue& value, const plant::Configuration* plants, Problems& problems);

void apply(const PlantValue& value, plant::Plants& plants, io::Rack& rack, Instant now);
// ~= within a relative tolerance of 1e-6.
bool holds(const PlantValue& value, block::Relation relation, const plant::Plants& plants);
std::string actualValue(const PlantValue& value, const plant::Plants& plants);

}  // namespace merker::simulator
