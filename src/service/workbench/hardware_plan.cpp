#include "workbench/hardware_plan.h"

#include <algorithm>
#include <map>

#include "io/configuration.h"
#include "workbench/counting_rows.h"
#include "workbench/fresh_errors.h"
#include "workbench/hardware_rows.h"
#include "workbench/hardware_settings.h"
#include "workbench/parameter_rows.h"
#include "workbench/serial_rows.h"

namespace merker::workbench {
namespace {

using project::ModulePlace;
using project::SettingsEdit;

constexpr std::size_t kLongestKey = 40;

ModulePlace placeIn(const Fields& change, const char* rack = "rack", const char* slot = "slot") {
  return {static_cast<std::uint32_t>(change.integer(rack, 0, 3, 0)), change.text(slot)};
}

SettingsEdit::Value valueIn(const Fields& change) {
  if (!change.has("value")) return std::nullopt;
  return change.literal("value");
}

std::string keyIn(const Fields& change, const char* name = "key") {
  const std::string key = change.text(name);
  const bool good =
      !key.empty() && key.size() <= kLongestKey && std::ranges::all_of(key, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '.';
      });
  if (!good) change.add(makeProblem(ProblemCode::P1305, nowhere(), change.path(name), "a key"));
  return key;
}

void place(SettingsEdit& edit, const Fields& change) {
  const ModulePlace to = placeIn(change);
  const std::string type = change.text("type");
  if (!change.good()) return;
  const auto found = findModuleTypes(type);
  if (found.size() != 1)
    change.add(makeProblem(ProblemCode::P0720, nowhere(), type));
  else if (edit.has(to))
    change.add(makeProblem(ProblemCode::P0725, nowhere(), to.slot, "another module"));
  else
    edit.add(to, found[0]->orderNumber);
}

void move(SettingsEdit& edit, const Fields& change) {
  const ModulePlace from = placeIn(change), to = placeIn(change, "toRack", "toSlot");
  if (!change.good() || from == to) return;
  if (edit.has(to))
    change.add(makeProblem(ProblemCode::P0725, nowhere(), to.slot, "another module"));
  else
    edit.move(from, to);
}

// What is on board has a table only if something of it is set.
void set(SettingsEdit& edit, const Fields& change) {
  const std::string key = keyIn(change);
  const SettingsEdit::Value value = valueIn(change);
  if (change.has("table")) {
    const std::string table = keyIn(change, "table");
    if (change.good()) edit.setIn(table, key, value);
    return;
  }
  const ModulePlace at = placeIn(change);
  if (!change.good()) return;
  if (value && !edit.has(at)) edit.add(at, "");
  if (!change.has("side")) {
    edit.set(at, key, value);
    if (key == "serial.baud") raiseSerialTimes(edit, at);
    return;
  }
  const std::string side = keyIn(change, "side");
  const auto number = static_cast<std::uint32_t>(change.integer("number", 0, 31));
  if (!change.good()) return;
  if (side == "number") dropCounting(edit, at, number, key, value.value_or(""));
  edit.setChannel(at, side, number, key, value);
}

void remove(SettingsEdit& edit, const Fields& change) {
  const ModulePlace at = placeIn(change);
  if (change.good()) edit.remove(at);
}

SettingsEdit::Pairs pairsIn(const Fields& change, const char* list) {
  constexpr std::size_t kMost = 100;
  SettingsEdit::Pairs pairs;
  if (!change.has(list)) return pairs;
  for (const Fields& one : change.objects(list, kMost))
    pairs.emplace_back(keyIn(one), one.literal("value"));
  return pairs;
}

void addPlant(SettingsEdit& edit, const Fields& change) {
  (void)change.name("name"), (void)change.name("kind");
  const std::string name = change.literal("name"), kind = change.literal("kind");
  const SettingsEdit::Pairs parameters = pairsIn(change, "parameters");
  const SettingsEdit::Pairs wires = pairsIn(change, "wires");
  if (change.good()) edit.addPlant(name, kind, parameters, wires);
}

enum ChangeKind : std::size_t { Place, Remove, Move, Set, AddPlant };

std::size_t changeKind(const Fields& change) {
  return change.choice("change", {"place", "remove", "move", "set", "plant"});
}

// Errors that were not there before, wherever they stand now.
bool stands(const project::Project& project, const ModulePlace& place) {
  return project.hardware && std::ranges::any_of(project.hardware->modules, [&](const auto& one) {
           return one.rack == place.rack && place.slot == std::to_string(one.slot) &&
                  one.position.line != 0;
         });
}

// The module whose lines these are; `modules` come in their order.
const project::ModuleLines* moduleAt(const std::vector<project::ModuleLines>& modules,
                                     std::uint32_t line) {
  const auto next = std::ranges::upper_bound(modules, line, {}, &project::ModuleLines::first);
  if (next == modules.begin()) return nullptr;
  const project::ModuleLines& found = *std::prev(next);
  return line < found.behind ? &found : nullptr;
}

Json problemRows(const SettingsEdit& edit, const Problems& problems) {
  const std::vector<project::ModuleLines> modules = edit.modules();
  Json list = firstOf(problems);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (const auto* at = moduleAt(modules, problems.list()[i].position.line))
      list[i].update({{"rack", at->place.rack}, {"slot", at->place.slot}});
  return list;
}

// Adds to each module what can be set on it.
void addParameters(Json& racks, const io::Configuration& configuration, const CpuModel& model) {
  std::map<std::pair<std::uint32_t, std::string>, const io::Module*> modules;
  for (const io::Module& module : configuration.modules)
    modules[{module.rack, module.slotText()}] = &module;
  for (Json& rack : racks)
    for (Json& slot : rack["slots"]) {
      const auto found = modules.find({rack["rack"], slot["slot"]});
      if (slot["kind"] == "cpu" || found == modules.end()) continue;
      slot["parameters"] = parameterRows(*found->second);
      slot["channels"] = channelRows(*found->second, model);
    }
}

// S7-HW-12: where HW Konfig lets a module be dropped.
Json slotsOf(const ModuleType& type) {
  if (type.kind == ModuleKind::PowerSupply) return {1, 1};
  if (type.kind == ModuleKind::Interface) return {3, 3};
  return {4, 11};
}

}  // namespace

void applyChange(SettingsEdit& edit, const Fields& change) {
  constexpr void (*kChanges[])(SettingsEdit&, const Fields&) = {place, remove, move, set, addPlant};
  const std::size_t kind = changeKind(change);
  if (change.good()) kChanges[kind](edit, change);
}

Plan Plan::of(const SettingsEdit& edit, const ProjectFolder& folder) {
  Plan plan{project::loadConfiguration(folder.folder(), edit.text(), {}), {}};
  for (Problem problem : plan.project.problems.list()) {
    problem.position.file = folder.relative(problem.position.file);
    plan.problems.add(std::move(problem));
  }
  plan.problems.sort();
  return plan;
}

Problems reasonsAgainst(const Plan& before, const Plan& after, const Fields& change) {
  const std::size_t kind = changeKind(change);
  if (kind == Remove) return {};
  const bool placed = kind == Place  ? stands(after.project, placeIn(change))
                      : kind == Move ? stands(after.project, placeIn(change, "toRack", "toSlot"))
                                     : false;
  return placed ? Problems() : freshErrors(before.problems, after.problems);
}

Json planRows(const Plan& plan, const SettingsEdit& edit, const source::SymbolTable& symbols) {
  const project::Project& project = plan.project;
  Problems none;
  const io::Configuration configuration =
      project.hardware ? *project.hardware : io::configure({}, *project.model, none);
  Json racks = hardwareRows(configuration, nullptr, symbols), currents = Json::array();
  addParameters(racks, configuration, *project.model);
  addSettings(project, configuration, racks);
  for (std::uint32_t rack = 0; rack < project.model->racks; ++rack) {
    const io::Current current = io::current(configuration, rack);
    currents.push_back({{"rack", rack}, {"taken", current.taken}, {"possible", current.possible}});
  }
  return {{"racks", std::move(racks)},
          {"cpu", cpuParameterRows(project)},
          {"configured", project.hardware.has_value()},
          {"current", std::move(currents)},
          {"problems", problemRows(edit, plan.problems)}};
}

Json catalogueRows() {
  Json types = Json::array();
  for (const ModuleType& type : moduleTypes())
    types.push_back({{"order", type.orderNumber},
                     {"name", type.name},
                     {"text", type.text},
                     {"kind", kindOf(type.kind)},
                     {"slots", slotsOf(type)},
                     {"inputBytes", type.inputBytes},
                     {"outputBytes", type.outputBytes},
                     {"current", type.busCurrent}});
  return {{"types", std::move(types)}};
}

}  // namespace merker::workbench
