#include "plant/plants.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "clock/standstill.h"
#include "plant/silence.h"

namespace merker::plant {
namespace {

// Before the first change that a plant foresees, with a margin for sums of floating point.
Instant surelyAfter(Instant at, double seconds) {
  constexpr double kShare = 1e-4, kLongest = 3600;  // s
  const double sure = std::clamp(seconds * (1 - kShare) - kUnsure, 0.0, kLongest);
  return at + Duration{static_cast<std::int64_t>(sure * 1e9)};
}

}  // namespace

void Plants::Unit::findNext() { next = fresh ? at : std::min(nextStep, process->next()); }

Plants::Plants(Configuration configuration)
    : configuration_(std::move(configuration)), wiring_(wirings()) {
  units_.resize(configuration_.plants.size());
  told_.resize(configuration_.far.size());
  for (std::size_t i = 0; i < units_.size(); ++i) start(i, Instant{});
  findNext();
}

void Plants::start(std::size_t index, Instant now) {
  const PlantSettings& settings = configuration_.plants[index];
  Unit& unit = units_[index];
  unit = {};
  unit.process = settings.kind->make(settings.parameters);
  for (const Signal& signal : settings.kind->signals) unit.values.push_back(signal.rest);
  unit.shown.resize(settings.wires.size());
  unit.courses.resize(settings.wires.size());
  unit.at = now;
  if (settings.step.ns > 0) unit.nextStep = now + settings.step;
  unit.process->begin(unit.values);
  unit.findNext();
}

void Plants::findNext() {
  next_ = Instant::never();
  for (const Unit& unit : units_) next_ = std::min(next_, unit.next);
}

void Plants::show(io::Rack& rack, Instant at) {
  for (std::size_t i = 0; i < units_.size(); ++i) showOutputs(i, rack, at);
}

// In the order of time; at one instant in the order of merker.toml, so that a plant sees what those
// above it have just done.
void Plants::advance(io::Rack& rack, Instant now) {
  for (Standstill loop; next_ <= now && loop.moves(next_);) {
    const Instant at = next_;
    for (std::size_t i = 0; i < units_.size(); ++i)
      if (units_[i].next <= at) move(i, rack, at);
    findNext();
  }
}

void Plants::move(std::size_t index, io::Rack& rack, Instant to) {
  readInputs(index, rack);
  go(index, rack, to);
  Unit& unit = units_[index];
  const Duration step = configuration_.plants[index].step;
  while (unit.nextStep <= to) unit.nextStep = unit.nextStep + step;
  unit.findNext();
}

void Plants::go(std::size_t index, io::Rack& rack, Instant to) {
  Unit& unit = units_[index];
  unit.process->advance(unit.at, to, unit.values);
  unit.at = to;
  unit.fresh = false;
  unit.findNext();
  showOutputs(index, rack, to);
}

void Plants::readInputs(std::size_t index, const io::Rack& rack,
                        std::vector<double>& values) const {
  const PlantSettings& settings = configuration_.plants[index];
  for (const Wire& wire : settings.wires) {
    if (settings.kind->signals[wire.signal].side != Signal::Side::Input) continue;
    double& value = values[wire.signal];
    if (const auto* other = std::get_if<SignalPlace>(&wire.end)) {
      value = this->value(*other);
      continue;
    }
    if (const auto* far = std::get_if<FarEnd>(&wire.end)) {
      value = (told_[far->number] - wire.offset) / wire.scale;
      continue;
    }
    if (const auto* data = std::get_if<io::ProcessData>(&wire.end)) {
      value = data->words == 0 ? rack.exchanging(data->module) : rack.received(*data);
      continue;
    }
    const auto& terminal = std::get<io::Terminal>(wire.end);
    value = isDigital(terminal.side) ? double(rack.level(terminal))
                                     : (rack.amount(terminal) - wire.offset) / wire.scale;
  }
  for (const Stuck& stuck : units_[index].stuck)
    if (settings.kind->signals[stuck.signal].side == Signal::Side::Input)
      values[stuck.signal] = stuck.value;
}

std::vector<Plants::Wiring> Plants::wirings() const {
  std::vector<Wiring> all(configuration_.plants.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Wire& wire : configuration_.plants[i].wires) {
      const Signal& signal = configuration_.plants[i].kind->signals[wire.signal];
      if (const auto* other = std::get_if<SignalPlace>(&wire.end))
        all[i].fed = all[other->plant].feeds = true;
      else if (!std::holds_alternative<io::Terminal>(wire.end))
        all[i].bus = true;
      else if (signal.side == Signal::Side::Output && signal.binary)
        all[i].switches = true;
      else if (signal.side == Signal::Side::Output)
        all[i].analog.push_back(std::get<io::Terminal>(wire.end).module);
    }
  return all;
}

Instant Plants::silentUntil(std::size_t index, const io::Rack& rack, bool amounts) const {
  const Unit& unit = units_[index];
  const Wiring& wiring = wiring_[index];
  const auto seen = [&](std::uint32_t module) { return amounts || !rack.onlyByAccess(module); };
  if (unit.fresh || wiring.bus || std::ranges::any_of(wiring.analog, seen)) return unit.next;
  if (!wiring.switches) return unit.process->next();
  if (wiring.fed) return unit.next;
  std::vector<double> values = unit.values;
  readInputs(index, rack, values);
  const double seconds = unit.process->silence(values);
  return std::min(unit.process->next(), std::max(unit.next, surelyAfter(unit.at, seconds)));
}

// The steps that are due, with the inputs as they stand.
void Plants::stepSilently(std::size_t index, const io::Rack& rack, Instant to) {
  Unit& unit = units_[index];
  const Duration step = configuration_.plants[index].step;
  const bool even = step.ns > 0 && unit.at + step == unit.nextStep && !unit.fresh;
  if (!even || unit.nextStep > to) return;
  readInputs(index, rack);
  const std::int64_t count = (to - unit.at).ns / step.ns;
  unit.process->advanceSteps(unit.at, step, count, unit.values);
  unit.at = unit.at + step * count;
  unit.nextStep = unit.at + step;
  unit.findNext();
}

void Plants::advanceAlone(io::Rack& rack, Instant now) {
  for (std::size_t i = 0; i < units_.size(); ++i)
    if (const Wiring& w = wiring_[i]; w.analog.empty() && !w.fed && !w.feeds && !w.bus)
      stepSilently(i, rack, now);
  findNext();
}

Instant Plants::silentUntil(const io::Rack& rack, bool amounts) const {
  Instant until = Instant::never();
  for (std::size_t i = 0; i < units_.size(); ++i)
    until = std::min(until, silentUntil(i, rack, amounts));
  return until;
}

// Only what has changed, so that what somebody else lays at a terminal stays there until then.
void Plants::showOutputs(std::size_t index, io::Rack& rack, Instant now) {
  const PlantSettings& settings = configuration_.plants[index];
  for (std::size_t i = 0; i < settings.wires.size(); ++i)
    if (settings.kind->signals[settings.wires[i].signal].side == Signal::Side::Output)
      showOutput(index, i, rack, now);
}

void Plants::showOutput(std::size_t index, std::size_t number, io::Rack& rack, Instant now) {
  Unit& unit = units_[index];
  const Wire& wire = configuration_.plants[index].wires[number];
  if (const auto* data = std::get_if<io::ProcessData>(&wire.end))
    return answer(index, number, *data, rack);
  if (std::holds_alternative<FarEnd>(wire.end)) return;  // whoever carries it looks at it
  const auto& terminal = std::get<io::Terminal>(wire.end);
  auto course = unit.stuckAt(wire.signal) ? nullptr : unit.process->course(wire.signal);
  if (course != nullptr) {
    if (unit.courses[number] == course) return;
    rack.attach(terminal, course, now);
    unit.courses[number] = std::move(course);
    unit.shown[number].reset();
    return;
  }
  unit.courses[number] = nullptr;
  const double value = this->value({static_cast<std::uint32_t>(index), wire.signal});
  if (unit.shown[number] == value) return;
  unit.shown[number] = value;
  if (isDigital(terminal.side))
    rack.setLevel(terminal, value != 0, now);
  else
    rack.setAmount(terminal, wire.offset + wire.scale * value, now);
}

void Plants::answer(std::size_t index, std::size_t number, const io::ProcessData& data,
                    io::Rack& rack) {
  const std::uint32_t signal = configuration_.plants[index].wires[number].signal;
  const double value = this->value({static_cast<std::uint32_t>(index), signal});
  if (std::exchange(units_[index].shown[number], value) == value) return;
  rack.answer(data, static_cast<std::int32_t>(std::llround(value)));
}

double Plants::value(SignalPlace place) const {
  const Unit& unit = units_[place.plant];
  const Stuck* stuck = unit.stuckAt(place.signal);
  return stuck == nullptr ? unit.values[place.signal] : stuck->value;
}

double Plants::shows(std::uint32_t farWire) const {
  const FarWire& far = configuration_.far[farWire];
  const Wire& wire = configuration_.plants[far.plant].wires[far.wire];
  return wire.offset + wire.scale * value({far.plant, wire.signal});
}

void Plants::set(io::Rack& rack, SignalPlace place, double value, Instant now) {
  Unit& unit = units_[place.plant];
  go(place.plant, rack, now);  // up to now with the value before
  unit.values[place.signal] = value;
  for (Stuck& stuck : unit.stuck) {
    if (stuck.signal != place.signal) continue;
    stuck.told = value;
    unit.values[place.signal] = stuck.value;
  }
  go(place.plant, rack, now);
  findNext();
}

}  // namespace merker::plant
