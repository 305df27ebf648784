#include "plant/plants.h"

#include <algorithm>
#include <utility>

namespace merker::plant {
Instant Plants::Unit::next() const { return fresh ? at : std::min(nextStep, process->next()); }

Plants::Plants(Configuration configuration) : configuration_(std::move(configuration)) {
  for (const PlantSettings& settings : configuration_.plants) {
    Unit& unit = units_.emplace_back();
    unit.process = settings.kind->make(settings.parameters);
    for (const Signal& signal : settings.kind->signals) unit.values.push_back(signal.rest);
    if (settings.step.ns > 0) unit.nextStep = Instant{} + settings.step;
    unit.process->begin(unit.values);
  }
  findNext();
}

void Plants::findNext() {
  next_ = Instant::never();
  for (const Unit& unit : units_) next_ = std::min(next_, unit.next());
}

// In the order of time; at one instant in the order of merker.toml, so that a plant sees what those
// above it have just done.
void Plants::advance(io::Rack& rack, Instant now) {
  while (next_ <= now) {
    const Instant at = next_;
    for (std::size_t i = 0; i < units_.size(); ++i)
      if (units_[i].next() <= at) move(i, rack, at);
    findNext();
  }
}

void Plants::move(std::size_t index, io::Rack& rack, Instant to) {
  readInputs(index, rack);
  go(index, rack, to);
  Unit& unit = units_[index];
  const Duration step = configuration_.plants[index].step;
  while (unit.nextStep <= to) unit.nextStep = unit.nextStep + step;
}

void Plants::go(std::size_t index, io::Rack& rack, Instant to) {
  Unit& unit = units_[index];
  unit.process->advance(unit.at, to, unit.values);
  unit.at = to;
  unit.fresh = false;
  showOutputs(index, rack, to);
}

void Plants::readInputs(std::size_t index, const io::Rack& rack) {
  const PlantSettings& settings = configuration_.plants[index];
  for (const Wire& wire : settings.wires) {
    if (settings.kind->signals[wire.signal].side != Signal::Side::Input) continue;
    double& value = units_[index].values[wire.signal];
    if (const auto* other = std::get_if<SignalPlace>(&wire.end)) {
      value = this->value(*other);
      continue;
    }
    const auto& terminal = std::get<io::Terminal>(wire.end);
    value = isDigital(terminal.side) ? double(rack.level(terminal))
                                     : (rack.amount(terminal) - wire.offset) / wire.scale;
  }
}

void Plants::showOutputs(std::size_t index, io::Rack& rack, Instant now) const {
  const PlantSettings& settings = configuration_.plants[index];
  for (const Wire& wire : settings.wires) {
    if (settings.kind->signals[wire.signal].side != Signal::Side::Output) continue;
    const auto& terminal = std::get<io::Terminal>(wire.end);
    const double value = units_[index].values[wire.signal];
    if (isDigital(terminal.side))
      rack.setLevel(terminal, value != 0, now);
    else
      rack.setAmount(terminal, wire.offset + wire.scale * value, now);
  }
}

void Plants::set(io::Rack& rack, SignalPlace place, double value, Instant now) {
  go(place.plant, rack, now);  // up to now with the value before
  units_[place.plant].values[place.signal] = value;
  go(place.plant, rack, now);
  findNext();
}

}  // namespace merker::plant
