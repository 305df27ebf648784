// The plants beside the station: what they show, what can be set (as scenarios do with `plant`).
#include "simulator/plant_steps.h"
#include "workbench/method.h"
#include "workbench/process_rows.h"

namespace merker::workbench {
namespace {

Answer list(const Call& call) {
  const plant::Plants* plants = std::as_const(call.station()).plants();
  return Json{{"plants", plants == nullptr ? Json::array() : plantRows(*plants)}};
}

Answer watch(const Call& call) {
  const bool on = call.fields.flag("on");
  if (!call.fields.good()) return call.fields.problems();
  call.browser.process = on;
  call.browser.processValues = nullptr;
  return empty();
}

Answer set(const Call& call) {
  const std::string plant = call.fields.text("plant"), value = call.fields.text("value");
  const double to = call.fields.number("to", -1e12, 1e12);
  if (!call.fields.good()) return call.fields.problems();
  plant::Plants* plants = call.station().plants();
  const std::string signal = plant + "." + value, number = fmt::format("{}", to);
  simulator::PlantValue wanted;
  wanted.isSet = true;
  Problems problems;
  const auto at = [](std::string_view) { return nowhere(); };
  if (simulator::parsePlant(signal, number, wanted, at, problems))
    simulator::resolve(wanted, plants == nullptr ? nullptr : &plants->configuration(), problems);
  if (problems.hasErrors()) return problems;
  simulator::set(wanted, *plants, *call.station().rack(), call.station().now());
  return empty();
}

Answer fault(const Call& call) {
  const std::string plant = call.fields.text("plant"), name = call.fields.text("fault");
  call.fields.flag("on");
  if (!call.fields.good()) return call.fields.problems();
  return refused(ProblemCode::P1307, plant, "fault '" + name + "'");
}

constexpr Method kMethods[] = {
    {"process.list", Needs::S7, list},
    {"process.watch", Needs::S7, watch},
    {"process.set", Needs::S7, set},
    {"process.fault", Needs::S7, fault},
};

}  // namespace

std::span<const Method> processMethods() { return kMethods; }

}  // namespace merker::workbench
