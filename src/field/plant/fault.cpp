// Faults of plants: sensors and actuators that are stuck. And the way back to the beginning.
#include <algorithm>

#include "plant/plants.h"

namespace merker::plant {

const Plants::Stuck* Plants::Unit::foundStuck(std::uint32_t signal) const {
  const auto found = std::find_if(stuck.begin(), stuck.end(),
                                  [signal](const Stuck& one) { return one.signal == signal; });
  return found == stuck.end() ? nullptr : &*found;
}

std::optional<double> Plants::stuck(SignalPlace place) const {
  const Stuck* stuck = units_[place.plant].stuckAt(place.signal);
  return stuck == nullptr ? std::nullopt : std::optional(stuck->value);
}

void Plants::stick(io::Rack& rack, SignalPlace place, std::optional<double> value, Instant now) {
  const double at = value.value_or(this->value(place));
  release(rack, place, now);
  Unit& unit = units_[place.plant];
  unit.stuck.push_back({place.signal, at, unit.values[place.signal]});
  move(place.plant, rack, now);
  findNext();
}

// An input goes on with what it has been told meanwhile; a wired one is read anyway.
void Plants::release(io::Rack& rack, SignalPlace place, Instant now) {
  Unit& unit = units_[place.plant];
  go(place.plant, rack, now);
  const Stuck* stuck = unit.stuckAt(place.signal);
  if (stuck == nullptr) return;
  const Kind& kind = *configuration_.plants[place.plant].kind;
  if (kind.signals[place.signal].side == Signal::Side::Input)
    unit.values[place.signal] = stuck->told;
  unit.stuck.erase(unit.stuck.begin() + (stuck - unit.stuck.data()));
  move(place.plant, rack, now);
  findNext();
}

void Plants::reset(io::Rack& rack, std::uint32_t plant, Instant now) {
  start(plant, now);
  move(plant, rack, now);
  findNext();
}

}  // namespace merker::plant
