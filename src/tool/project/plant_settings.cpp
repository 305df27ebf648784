// [[plant]] of merker.toml: machines and processes.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "project/plant_reader.h"
#include "project/readers.h"

namespace merker::project {
namespace {

using plant::Kind;
using plant::PlantSettings;

const Kind* readKind(const Table& table) {
  if (!table.has("kind")) {
    table.problems().add(ProblemCode::P0760, table.place(), "kind",
                         "one of: " + plant::kindNames());
    return nullptr;
  }
  const auto name = table.text("kind", "one of: " + plant::kindNames());
  const Kind* kind = name ? plant::findKind(*name) : nullptr;
  if (name && kind == nullptr)
    table.problems().add(ProblemCode::P0761, table.at("kind"), *name, plant::kindNames());
  return kind;
}

Duration inTime(double seconds) { return {std::llround(seconds * 1e9)}; }

double readParameter(const Table& table, const plant::Parameter& parameter) {
  using Form = plant::Parameter::Form;
  if (parameter.form == Form::Number)
    return table.real(parameter.key, parameter.low, parameter.high).value_or(parameter.standard);
  if (parameter.form == Form::Flag)
    return table.flag(parameter.key).value_or(parameter.standard != 0) ? 1 : 0;
  if (parameter.form == Form::Whole)
    return static_cast<double>(
        table.integer(parameter.key, std::llround(parameter.low), std::llround(parameter.high))
            .value_or(std::llround(parameter.standard)));
  const auto length = table.length(parameter.key, inTime(parameter.low), inTime(parameter.high));
  return length ? static_cast<double>(length->ns) / 1e9 : parameter.standard;
}

// It stands between others in scenarios and on the command line: "plant Press/Oven.PV, MW 10".
bool isWord(std::string_view name) {
  constexpr char kLastControl = ' ', kDelete = 0x7F;
  return !name.empty() && std::ranges::none_of(name, [](char c) {
    return (c >= 0 && c <= kLastControl) || c == kDelete ||
           std::string_view(".,:/=\"").find(c) != std::string_view::npos;
  });
}

// `ofStations`: it names its station.
void readParameters(const Table& table, bool ofStations, PlantSettings& plant) {
  std::vector<std::string_view> keys{"name", "kind", "step", "wire"};
  if (ofStations) keys.push_back("station");
  for (const plant::Parameter& parameter : plant.kind->parameters) {
    keys.push_back(parameter.key);
    plant.parameters.push_back(readParameter(table, parameter));
  }
  table.allow(keys);
  plant.step = plant.kind->step;
  if (const auto step =
          table.length("step", Duration::microseconds(100), Duration::seconds(1)))  // PID-SIM-01
    plant.step = *step;
}

// Without its bus it has no master; behind both switches at once it never gets away.
void checkDrive(const Table& table, const PlantSettings& plant) {
  const auto wires = table.table("wire");
  if (!wires || !wires->has(plant::kBusSignal))
    table.problems().add(ProblemCode::P0760, table.place(), plant::kBusSignal,
                         "the slave it is: [plant.wire] BUS = \"Drive\"");
  const auto value = [&](std::string_view key) {
    const auto& rows = plant.kind->parameters;
    const auto row = std::ranges::find(rows, key, &plant::Parameter::key);
    return plant.parameters[static_cast<std::size_t>(row - rows.begin())];
  };
  if (value("low_switch") >= value("high_switch"))
    table.mustBe(table.has("high_switch") ? "high_switch" : "low_switch",
                 "so that low_switch is below high_switch");
}

}  // namespace

bool PlantReader::readName(const Table& table, PlantSettings& plant) const {
  if (!table.has("name"))
    table.problems().add(ProblemCode::P0760, table.place(), "name", "the name used in scenarios");
  const auto name = table.text("name", "a text");
  if (!name) return false;
  plant.name = *name;
  if (!isWord(*name)) {
    table.mustBe("name", "a word without blanks, control characters and . , : / = \"");
    return false;
  }
  if (plants_.find(*name) || rack_.module(*name)) {
    table.problems().add(ProblemCode::P0742, table.at("name"), *name,
                         plants_.find(*name) ? "another plant" : "a module");
    return false;
  }
  return true;
}

void PlantReader::read(const Table& table) {
  PlantSettings plant;
  const bool named = readName(table, plant);
  plant.kind = readKind(table);
  if (!named || plant.kind == nullptr) refused_.insert(upper(plant.name));
  if (plant.kind == nullptr) return;
  readParameters(table, stations_ != nullptr, plant);
  if (const auto wires = table.table("wire")) readWires(*wires, plant);
  if (plant.kind->telegram != nullptr) checkDrive(table, plant);
  if (named) plants_.plants.push_back(std::move(plant));
}

plant::Configuration readPlants(const Table& root, const io::Configuration& modules) {
  plant::Configuration plants;
  PlantReader reader(modules, plants);
  std::vector<std::set<std::string>> names(1);
  for (const Table& table : root.tables("plant"))
    if (const toml::node* name = table.node("name"); name != nullptr && name->is_string())
      names.front().insert(upper(name->as_string()->get()));
  reader.expect(names);
  for (const Table& table : root.tables("plant")) reader.read(table);
  return plants;
}

}  // namespace merker::project
