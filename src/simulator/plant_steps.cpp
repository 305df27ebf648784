#include "simulator/plant_steps.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/text.h"
#include "simulator/relation.h"

namespace merker::simulator {
namespace {

using plant::Signal;

const Signal& signalOf(const plant::Configuration& plants, plant::SignalPlace place) {
  return plants.plants[place.plant].kind->signals[place.signal];
}

std::optional<double> number(std::string_view text, bool binary) {
  if (equalsIgnoreCase(text, "true")) return 1;
  if (equalsIgnoreCase(text, "false")) return 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
      (binary && value != 0 && value != 1))
    return std::nullopt;
  return value;
}

// Why a scenario cannot set this signal; empty if it can.
std::string whyNot(const plant::Configuration& plants, plant::SignalPlace place) {
  if (signalOf(plants, place).side == Signal::Side::Output) return "it is an output of the plant";
  const plant::Wire* wire = plants.plants[place.plant].wireOf(place.signal);
  return wire == nullptr ? "" : fmt::format("it is wired to {}", wire->text);
}

}  // namespace

bool parsePlant(std::string_view signal, std::string_view value, PlantValue& result,
                const PositionOf& at, Problems& problems) {
  result.text = signal;
  result.position = at(signal);
  result.value = value;
  result.valuePosition = at(value.empty() ? signal : value);
  if (signal.find('.') != std::string_view::npos) return true;
  problems.add(ProblemCode::P0952, at(signal), "a signal of a plant: PLANT.SIGNAL");
  return false;
}

void resolve(PlantValue& value, const plant::Configuration* plants, Problems& problems) {
  if (plants == nullptr || plants->plants.empty()) {
    problems.add(ProblemCode::P0987, value.position);
    return;
  }
  const auto point = value.text.find('.');
  const auto found = plants->find(value.text.substr(0, point));
  if (!found) {
    problems.add(ProblemCode::P0986, value.position, value.text.substr(0, point), plants->names());
    return;
  }
  const plant::PlantSettings& settings = plants->plants[*found];
  const auto signal = settings.kind->signal(value.text.substr(point + 1));
  if (!signal) {
    problems.add(ProblemCode::P0762, value.position, settings.name, value.text.substr(point + 1),
                 plant::signalNames(*settings.kind));
    return;
  }
  value.place = {*found, *signal};
  const std::string reason = value.isSet ? whyNot(*plants, value.place) : "";
  if (!reason.empty()) problems.add(ProblemCode::P0988, value.position, value.text, reason);
  const bool binary = signalOf(*plants, value.place).binary;
  const auto wanted = number(value.value, binary);
  if (!wanted)
    problems.add(ProblemCode::P0989, value.valuePosition, value.value, value.text,
                 binary ? "it is 0 or 1" : "it is a number: 12.5");
  value.number = wanted.value_or(0);
}

void set(const PlantValue& value, plant::Plants& plants, io::Rack& rack, Instant now) {
  plants.set(rack, value.place, value.number, now);
}

bool holds(const PlantValue& value, block::Relation relation, const plant::Plants& plants) {
  const double is = plants.value(value.place);
  if (relation != block::Relation::About) return relates(is, relation, value.number);
  return std::abs(is - value.number) <= 1e-6 * std::max(std::abs(is), std::abs(value.number));
}

std::string actualValue(const PlantValue& value, const plant::Plants& plants) {
  return fmt::format("{:.7g}", plants.value(value.place));
}

}  // namespace merker::simulator
