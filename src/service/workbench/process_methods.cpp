// The plants beside the station: what they show, what can be set (as scenarios do with `plant`).
#include "scenario/plant_value.h"
#include "workbench/axis_shown.h"
#include "workbench/method.h"
#include "workbench/process_rows.h"

namespace merker::workbench {
namespace process_methods {
namespace {

using monitor::Feature;

Answer list(const Call& call) {
  return Json{{"plants", plantRows(call.field(), call.plc().build().project.symbols)},
              {"axis", axisRow(call.plc())}};
}

Answer kinds(const Call&) { return Json{{"kinds", plantKindRows()}}; }

Answer watch(const Call& call) {
  const bool on = call.fields.flag("on");
  if (!call.fields.good()) return call.fields.problems();
  call.browser.process = on;
  call.browser.processValues = nullptr;
  return empty();
}

// What the plant can take there, as process.list says it.
std::optional<Problem> checkRange(const plant::Signal& signal, double to, const std::string& text) {
  const bool good = signal.binary ? to == 0 || to == 1 : to >= signal.low && to <= signal.high;
  if (good) return std::nullopt;
  const std::string range =
      signal.binary ? "it is 0 or 1"
                    : fmt::format("it is a number from {} to {}{}{}", signal.low, signal.high,
                                  signal.unit.empty() ? "" : " ", signal.unit);
  return makeProblem(ProblemCode::P0989, nowhere(), fmt::format("{}", to), text, range);
}

Answer set(const Call& call) {
  const std::string plant = call.fields.text("plant"), value = call.fields.text("value");
  const double to = call.fields.number("to", -1e12, 1e12);
  const bool held = call.fields.flag("held", false);
  if (!call.fields.good()) return call.fields.problems();
  plant::Plants* plants = call.field().plants();
  const std::string signal = fmt::format("{}.{}", plant, value), number = fmt::format("{}", to);
  simulator::PlantValue wanted;
  wanted.does = simulator::PlantValue::Does::Set;
  Problems problems;
  const auto at = [](std::string_view) { return nowhere(); };
  if (simulator::parsePlant(signal, number, wanted, at, problems))
    simulator::resolve(wanted, plants == nullptr ? nullptr : &plants->configuration(), problems);
  if (problems.hasErrors()) return problems;
  const plant::Kind& kind = *plants->configuration().plants[wanted.place.plant].kind;
  if (auto problem = checkRange(kind.signals[wanted.place.signal], wanted.number, signal))
    return one(std::move(*problem));
  simulator::apply(wanted, *plants, *call.field().rack(), call.plc().controller().now());
  held ? void(call.browser.held.emplace(plant, value))
       : void(call.browser.held.erase({plant, value}));
  return empty();
}

// A plant by its name, and a signal of it.
Result<std::uint32_t> plantNamed(const Call& call, const std::string& name) {
  const plant::Plants* plants = std::as_const(call.field()).plants();
  if (plants == nullptr || plants->configuration().plants.empty())
    return makeProblem(ProblemCode::P0987, nowhere());
  const auto found = plants->configuration().find(name);
  if (found) return *found;
  return makeProblem(ProblemCode::P0986, nowhere(), name, plants->configuration().names());
}

// Its fault is that a signal is stuck: at `to`, or at the value it has now.
Answer fault(const Call& call) {
  const std::string name = call.fields.text("plant"), signal = call.fields.text("fault");
  const bool on = call.fields.flag("on");
  std::optional<double> to;
  if (call.fields.has("to")) to = call.fields.number("to", -1e12, 1e12);
  if (!call.fields.good()) return call.fields.problems();
  const auto plant = plantNamed(call, name);
  if (!plant) return one(plant.error());
  plant::Plants& plants = *call.field().plants();
  const plant::Kind& kind = *plants.configuration().plants[*plant].kind;
  const auto found = kind.signal(signal);
  if (!found) return refused(ProblemCode::P0762, kind.name, signal, plant::signalNames(kind));
  if (auto problem = to ? checkRange(kind.signals[*found], *to, signal) : std::nullopt)
    return one(std::move(*problem));
  io::Rack& rack = *call.field().rack();
  const plant::SignalPlace place{*plant, *found};
  on ? plants.stick(rack, place, to, call.plc().controller().now())
     : plants.release(rack, place, call.plc().controller().now());
  return empty();
}

Answer reset(const Call& call) {
  const std::string name = call.fields.text("plant");
  if (!call.fields.good()) return call.fields.problems();
  const auto plant = plantNamed(call, name);
  if (!plant) return one(plant.error());
  call.field().plants()->reset(*call.field().rack(), *plant, call.plc().controller().now());
  return empty();
}

constexpr Method kMethods[] = {
    {"process.list", Needs::able(Feature::Plants), list},
    {"process.kinds", Needs::able(Feature::Rack), kinds},
    {"process.watch", Needs::able(Feature::Plants), watch},
    {"process.set", Needs::able(Feature::Plants), set, Kind::Action},
    {"process.fault", Needs::able(Feature::Plants), fault, Kind::Action},
    {"process.reset", Needs::able(Feature::Plants), reset, Kind::Action},
};

}  // namespace
}  // namespace process_methods

void releaseHeld(Shared& shared, const Browser& browser) {
  plant::Field* const field = shared.plc ? shared.plc->field() : nullptr;
  if (field == nullptr || field->plants() == nullptr) return;
  const plant::Configuration& plants = field->plants()->configuration();
  for (const auto& [plant, signal] : browser.held) {
    const auto number = plants.find(plant);
    const auto place = number ? plants.plants[*number].kind->signal(signal) : std::nullopt;
    if (!place) continue;  // of a project that is closed
    simulator::PlantValue wanted;
    wanted.does = simulator::PlantValue::Does::Set;
    wanted.place = {*number, *place};
    wanted.number = plants.plants[*number].kind->signals[*place].rest;
    simulator::apply(wanted, *field->plants(), *field->rack(), shared.plc->controller().now());
  }
}

std::span<const Method> processMethods() { return process_methods::kMethods; }

}  // namespace merker::workbench
