#include "scenario/plant_value.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/text.h"
#include "check/relation.h"

namespace merker::simulator {
namespace {

using plant::Signal;
using Does = PlantValue::Does;

constexpr double kMost = 1e9;  // as the parameters of plants

const Signal& signalOf(const plant::Configuration& plants, plant::SignalPlace place) {
  return plants.plants[place.plant].kind->signals[place.signal];
}

std::optional<double> number(std::string_view text, bool binary) {
  if (binary && equalsIgnoreCase(text, "true")) return 1;
  if (binary && equalsIgnoreCase(text, "false")) return 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
      std::abs(value) > kMost || (binary && value != 0 && value != 1))
    return std::nullopt;
  return value;
}

// Why a scenario cannot set this signal; empty if it can.
std::string whyNot(const plant::Configuration& plants, plant::SignalPlace place) {
  if (signalOf(plants, place).side == Signal::Side::Output) return "it is an output of the plant";
  const plant::Wire* wire = plants.plants[place.plant].wireOf(place.signal);
  return wire == nullptr ? "" : fmt::format("it is wired to {}", wire->text);
}

constexpr std::string_view kWords =
    "PLANT.SIGNAL = VALUE, PLANT.SIGNAL stuck [VALUE], PLANT.SIGNAL free, or PLANT reset";

struct Verb {
  std::string_view word;
  Does does;
  bool takesValue = false;
};
constexpr Verb kVerbs[] = {
    {"stuck", Does::Stick, true}, {"free", Does::Release}, {"reset", Does::Reset}};

bool hasValue(Does does) { return does <= Does::Stick; }

// "Belt.BARRIER_SMALL stuck 0": which verb, and what stands before and behind it.
bool parseVerb(std::string_view part, PlantValue& result, std::string_view& name,
               std::string_view& value) {
  value = part;
  name = takeWord(value);
  const std::string_view word = takeWord(value);
  for (const Verb& verb : kVerbs) {
    if (!equalsIgnoreCase(word, verb.word) || (!value.empty() && !verb.takesValue)) continue;
    result.does = verb.does == Does::Stick && value.empty() ? Does::StickAsItIs : verb.does;
    return true;
  }
  return false;
}

// A word of a telegram holds a whole number of 16 bits, with or without a sign.
bool fitsWord(double value, const plant::Wire* wire) {
  const auto* const data = wire != nullptr ? std::get_if<io::ProcessData>(&wire->end) : nullptr;
  return data == nullptr || data->words != 1 ||
         (value == std::floor(value) && value >= -32'768 && value <= 65'535);
}

// The number that the text of a value means to its signal.
void resolveNumber(PlantValue& value, bool binary, const plant::Wire* wire, Problems& problems) {
  const auto wanted = number(value.value, binary);
  if (!wanted)
    problems.add(ProblemCode::P0989, value.valuePosition, value.value, value.text,
                 binary ? "it is 0 or 1" : "it is a number up to 1e9: 12.5");
  else if (!fitsWord(*wanted, wire))
    problems.add(ProblemCode::P0989, value.valuePosition, value.value, value.text,
                 "it is a word: a whole number from -32768 to 65535");
  value.number = wanted.value_or(0);
}

void resolveSignal(PlantValue& value, std::string_view name, const plant::Configuration& plants,
                   Problems& problems) {
  const plant::PlantSettings& settings = plants.plants[value.place.plant];
  const auto signal = settings.kind->signal(name);
  if (!signal) {
    problems.add(ProblemCode::P0762, value.position, settings.name, name,
                 plant::signalNames(*settings.kind));
    return;
  }
  value.place.signal = *signal;
  const std::string reason = value.does == Does::Set ? whyNot(plants, value.place) : "";
  if (!reason.empty()) problems.add(ProblemCode::P0988, value.position, value.text, reason);
  if (hasValue(value.does))
    resolveNumber(value, signalOf(plants, value.place).binary, settings.wireOf(*signal), problems);
}

}  // namespace

bool parsePlant(std::string_view signal, std::string_view value, PlantValue& result,
                const PositionOf& at, Problems& problems) {
  result.text = signal;
  result.position = at(signal);
  result.value = value;
  result.valuePosition = at(value.empty() ? signal : value);
  const bool named = signal.find('.') != std::string_view::npos;
  if (named != (result.does == Does::Reset)) return true;
  problems.add(ProblemCode::P0952, at(signal),
               named ? "the name of a plant: PLANT reset" : "a signal of a plant: PLANT.SIGNAL");
  return false;
}

bool parsePlantStep(std::string_view part, PlantValue& result, const PositionOf& at,
                    Problems& problems) {
  const auto sign = part.find('=');
  std::string_view name, value;
  if (sign != std::string_view::npos) {
    result.does = Does::Set;
    name = trim(part.substr(0, sign));
    value = trim(part.substr(sign + 1));
  } else if (!parseVerb(part, result, name, value)) {
    problems.add(ProblemCode::P0952, at(part), kWords);
    return false;
  }
  return parsePlant(name, value, result, at, problems);
}

void resolve(PlantValue& value, const plant::Configuration* plants, Problems& problems) {
  if (plants == nullptr || plants->plants.empty()) {
    problems.add(ProblemCode::P0987, value.position);
    return;
  }
  const std::string_view text = value.text;
  const auto point = text.find('.');
  const auto found = plants->find(text.substr(0, point));
  if (!found) {
    problems.add(ProblemCode::P0986, value.position, text.substr(0, point), plants->names());
    return;
  }
  value.place.plant = *found;
  if (value.does != Does::Reset) resolveSignal(value, text.substr(point + 1), *plants, problems);
}

void apply(const PlantValue& value, plant::Plants& plants, io::Rack& rack, Instant now) {
  switch (value.does) {
    case Does::Set:
      return plants.set(rack, value.place, value.number, now);
    case Does::Stick:
      return plants.stick(rack, value.place, value.number, now);
    case Does::StickAsItIs:
      return plants.stick(rack, value.place, std::nullopt, now);
    case Does::Release:
      return plants.release(rack, value.place, now);
    case Does::Reset:
      return plants.reset(rack, value.place.plant, now);
    case Does::Look:
      return;
  }
}

bool holds(const PlantValue& value, block::Relation relation, const plant::Plants& plants) {
  using block::Relation;
  const double is = plants.value(value.place);
  // Equal is what looks equal in a message (seven digits).
  const bool equal = block::about(is, value.number);
  if (relation == Relation::Equal || relation == Relation::About) return equal;
  if (relation == Relation::NotEqual) return !equal;
  return block::relates(is, relation, value.number);
}

std::string actualValue(const PlantValue& value, const plant::Plants& plants) {
  return fmt::format("{:.7g}", plants.value(value.place));
}

}  // namespace merker::simulator
