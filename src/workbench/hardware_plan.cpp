#include "workbench/hardware_plan.h"

#include <algorithm>

#include "io/configuration.h"
#include "workbench/hardware_rows.h"
#include "workbench/parameter_rows.h"

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
  if (!change.has("side")) return edit.set(at, key, value);
  const std::string side = keyIn(change, "side");
  const auto number = static_cast<std::uint32_t>(change.integer("number", 0, 31));
  if (change.good()) edit.setChannel(at, side, number, key, value);
}

void remove(SettingsEdit& edit, const Fields& change) {
  const ModulePlace at = placeIn(change);
  if (change.good()) edit.remove(at);
}

enum ChangeKind : std::size_t { Place, Remove, Move, Set };

std::size_t kindOf(const Fields& change) {
  return change.choice("change", {"place", "remove", "move", "set"});
}

Problems problemsOf(const SettingsEdit& edit) {
  Problems problems = project::loadConfiguration("", edit.text(), {}).problems;
  problems.sort();
  return problems;
}

// Errors that were not there before, wherever they stand now.
Problems freshErrors(const Problems& before, const Problems& after) {
  Problems fresh;
  for (const Problem& problem : after.list()) {
    const bool old = std::ranges::any_of(before.list(), [&](const Problem& other) {
      return other.code == problem.code && other.message == problem.message;
    });
    if (!old && problem.severity() == Severity::Error) fresh.add(problem);
  }
  return fresh;
}

bool stands(const SettingsEdit& edit, const ModulePlace& place) {
  const project::Project project = project::loadConfiguration("", edit.text(), {});
  return project.hardware && std::ranges::any_of(project.hardware->modules, [&](const auto& one) {
           return one.rack == place.rack && place.slot == std::to_string(one.slot) &&
                  one.position.line != 0;
         });
}

Json problemRows(const SettingsEdit& edit, const Problems& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems.list()) {
    Json row = toJson(problem);
    if (const auto place = edit.moduleAt(problem.position.line))
      row.update({{"rack", place->rack}, {"slot", place->slot}});
    list.push_back(std::move(row));
  }
  return list;
}

// Adds to each module what can be set on it.
void addParameters(Json& racks, const io::Configuration& configuration) {
  for (Json& rack : racks)
    for (Json& slot : rack["slots"])
      for (const io::Module& module : configuration.modules)
        if (module.rack == rack["rack"] && slot["kind"] != "cpu" &&
            module.slotText() == slot["slot"]) {
          slot["parameters"] = parameterRows(module);
          slot["channels"] = channelRows(module);
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
  constexpr void (*kChanges[])(SettingsEdit&, const Fields&) = {place, remove, move, set};
  const std::size_t kind = kindOf(change);
  if (change.good()) kChanges[kind](edit, change);
}

Problems reasonsAgainst(const SettingsEdit& before, const SettingsEdit& after,
                        const Fields& change) {
  if (after.problem()) return one(*after.problem());
  const std::size_t kind = kindOf(change);
  if (kind == Remove) return {};
  const Problems fresh = freshErrors(problemsOf(before), problemsOf(after));
  const bool placed = kind == Place  ? stands(after, placeIn(change))
                      : kind == Move ? stands(after, placeIn(change, "toRack", "toSlot"))
                                     : false;
  return placed ? Problems() : fresh;
}

Json planRows(const SettingsEdit& edit, const source::SymbolTable& symbols) {
  const project::Project project = project::loadConfiguration("", edit.text(), {});
  Problems none;
  const io::Configuration configuration =
      project.hardware ? *project.hardware : io::configure({}, *project.model, none);
  Json racks = hardwareRows(configuration, nullptr, symbols), currents = Json::array();
  addParameters(racks, configuration);
  for (std::uint32_t rack = 0; rack < project.model->racks; ++rack) {
    const io::Current current = io::current(configuration, rack);
    currents.push_back({{"rack", rack}, {"taken", current.taken}, {"possible", current.possible}});
  }
  return {{"racks", std::move(racks)},
          {"cpu", cpuParameterRows(project)},
          {"configured", project.hardware.has_value()},
          {"current", std::move(currents)},
          {"problems", problemRows(edit, problemsOf(edit))}};
}

Json catalogueRows() {
  constexpr std::string_view kKinds[] = {"power supply",  "interface", "digital",
                                         "analog",        "position",  "function",
                                         "communication", "counting",  "positioning"};
  Json types = Json::array();
  for (const ModuleType& type : moduleTypes())
    types.push_back({{"order", type.orderNumber},
                     {"name", type.name},
                     {"text", type.text},
                     {"kind", kKinds[static_cast<std::size_t>(type.kind)]},
                     {"slots", slotsOf(type)},
                     {"inputBytes", type.inputBytes},
                     {"outputBytes", type.outputBytes},
                     {"current", type.busCurrent}});
  return {{"types", std::move(types)}};
}

}  // namespace merker::workbench
