// The racks, and faults of their modules (what scenarios do with `fault`).
#include "workbench/elsewhere.h"
#include "workbench/hardware_plan.h"
#include "workbench/hardware_rows.h"
#include "workbench/hardware_settings.h"
#include "workbench/slave_rows.h"

namespace merker::workbench {
namespace hardware_methods {
namespace {

using monitor::Feature;

Answer read(const Call& call) {
  const project::Project& project = call.plc().build().project;
  const io::Rack* rack = call.plc().rack();
  Problems none;
  const io::Configuration configuration =
      rack != nullptr ? rack->configuration() : io::configure({}, *project.model, none);
  Json racks = hardwareRows(configuration, rack, project.symbols);
  addSettings(project, configuration, racks);
  if (rack != nullptr) addSlaveRows(racks, *rack, project.symbols);
  return Json{{"racks", std::move(racks)}};
}

// Behind the racks there are AS-Interfaces, and DP slaves by their addresses.
constexpr std::int64_t kHighestRack = 1125;

std::optional<std::uint32_t> moduleAt(const io::Rack& rack, std::int64_t number,
                                      const std::string& slot) {
  const auto& modules = rack.configuration().modules;
  for (std::size_t i = 0; i < modules.size(); ++i)
    if (modules[i].rack == number && modules[i].slotText() == slot)
      return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

Answer fault(const Call& call) {
  const std::int64_t number = call.fields.integer("rack", 0, kHighestRack);
  const std::string slot = call.fields.text("slot"), name = call.fields.text("fault");
  const bool on = call.fields.flag("on");
  if (!call.fields.good()) return call.fields.problems();
  io::Rack* rack = call.field().rack();
  if (rack == nullptr)
    return refused(ProblemCode::P1307, "this project", "hardware configuration in merker.toml");
  const auto module = moduleAt(*rack, number, slot);
  if (!module)
    return refused(ProblemCode::P1316, "module", slot, fmt::format(" in rack {}", number));
  const io::FaultName* kind = io::findFault(name);
  if (kind == nullptr)
    return refused(ProblemCode::P1316, "fault", name, "; valid: " + io::faultNames());
  if (!rack->fault(*module, kind->kind, std::nullopt, on))
    return refused(ProblemCode::P1307, rack->configuration().modules[*module].title(),
                   "fault '" + name + "'");
  return empty();
}

Answer planned(const Aside& aside, const source::SymbolTable& symbols) {
  constexpr std::size_t kMostChanges = 100;
  const std::string text = aside.fields.text("text");
  if (text.size() > kLongestSettings)
    return refused(ProblemCode::P1305, "text",
                   fmt::format("a merker.toml of at most {} bytes", kLongestSettings));
  project::SettingsEdit edit("merker.toml", text);
  const auto changes = aside.fields.has("changes") ? aside.fields.objects("changes", kMostChanges)
                                                   : std::vector<Fields>();
  if (!aside.fields.good()) return aside.wrong();
  if (edit.problem()) return one(*edit.problem());
  Plan plan = Plan::of(edit, aside.folder);
  for (const Fields& change : changes) {
    if (aside.stop.stop_requested()) break;
    applyChange(edit, change);
    if (!aside.fields.good()) return aside.wrong();
    if (edit.problem()) return withoutPlace(one(*edit.problem()));
    if (edit.text().size() > kLongestSettings)
      return refused(ProblemCode::P1314, kLongestSettings, "bytes of merker.toml");
    Plan next = Plan::of(edit, aside.folder);
    const Problems against = reasonsAgainst(plan, next, change);
    if (against.hasErrors()) return withoutPlace(against);
    plan = std::move(next);
  }
  Json result = planRows(plan, edit, symbols);
  result["text"] = edit.text();
  return result;
}

// merker.toml as it would be with the changes. Without changes: what the text says.
Answer edit(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside& aside) {
                     return planned(aside, offline->build->project.symbols);
                   });
}

Answer catalogue(const Call&) { return catalogueRows(); }

constexpr Method kMethods[] = {
    {"hardware.read", Needs::able(Feature::Rack), read},
    {"hardware.fault", Needs::able(Feature::Rack), fault, Kind::Action},
    {"hardware.edit", Needs::able(Feature::Rack), edit, Kind::Compiled},
    {"hardware.catalogue", Needs::able(Feature::Rack), catalogue},
};

}  // namespace
}  // namespace hardware_methods

std::span<const Method> hardwareMethods() { return hardware_methods::kMethods; }

}  // namespace merker::workbench
