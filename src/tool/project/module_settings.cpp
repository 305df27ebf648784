// [[module]] of merker.toml: which module stands where.
#include <fmt/format.h>

#include <cmath>

#include "io/amount.h"
#include "project/axis_settings.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::string_view kSlotWords = "a slot: 4, or \"2.2\" on board of the CPU";

// The range is checked with the mounting rules.
bool readSlot(const Table& table, io::Module& module) {
  const toml::node* node = table.node("slot");
  if (node == nullptr) {
    table.problems().add(ProblemCode::P0722, table.place(), "slot", "for example slot = 4");
    return false;
  }
  module.slotPosition = table.at("slot");
  const std::string text = slotText(*node);
  const auto point = text.find('.');
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.size() <= 3 &&
           part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const bool onBoard = point != std::string::npos;
  if (!digits(text.substr(0, point)) || (onBoard && !digits(text.substr(point + 1)))) {
    table.mustBe("slot", kSlotWords);
    return false;
  }
  module.slot = static_cast<std::uint32_t>(std::stoul(text.substr(0, point)));
  if (onBoard) module.subslot = static_cast<std::uint32_t>(std::stoul(text.substr(point + 1)));
  return true;
}

std::string subModules(const CpuModel& model) {
  std::string list;
  for (unsigned subslot = 1; subslot <= 5; ++subslot)
    if (const ModuleType* type = onBoardType(model, subslot))
      list += fmt::format("{}2.{} {}", list.empty() ? "it has " : ", ", subslot, title(*type));
  return list.empty() ? "it has none" : list;
}

bool readOnBoard(const Table& table, const CpuModel& model, io::Module& module) {
  module.type = module.slot == 2 ? onBoardType(model, module.subslot) : nullptr;
  if (module.type == nullptr)
    table.problems().add(ProblemCode::P0743, table.at("slot"), model.name,
                         fmt::format("{}.{}", module.slot, module.subslot), subModules(model));
  if (table.has("type")) table.mustBe("type", "omitted: the CPU defines its modules on board");
  if (table.number("rack", 0, 99).value_or(0) != 0) table.mustBe("rack", "0, the rack of the CPU");
  return module.type != nullptr;
}

std::string titles(const std::vector<const ModuleType*>& types) {
  std::string list;
  for (const ModuleType* type : types)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", type->orderNumber, type->text);
  return list;
}

bool readType(const Table& table, io::Module& module) {
  if (!table.has("type")) {
    table.problems().add(ProblemCode::P0722, table.place(), "type",
                         "for example type = \"6ES7 321-1BH02-0AA0\"");
    return false;
  }
  const auto name = table.text("type", "an order number or a name, \"SM 321 DI16xDC24V\"");
  if (!name) return false;
  const auto found = findModuleTypes(*name);
  if (found.empty()) table.problems().add(ProblemCode::P0720, table.at("type"), *name);
  if (found.size() > 1)
    table.problems().add(ProblemCode::P0721, table.at("type"), *name, titles(found));
  if (found.size() != 1) return false;
  module.type = found[0];
  return true;
}

bool readPlace(const Table& table, const CpuModel& model, io::Module& module) {
  if (!readSlot(table, module)) return false;
  if (module.subslot != 0) return readOnBoard(table, model, module);
  if (const auto rack = table.number("rack", 0, 99)) {
    module.rack = *rack;
    module.rackPosition = table.at("rack");
  }
  return readType(table, module);
}

void readAddress(const Table& table, std::string_view key, bool has, std::string_view what,
                 std::optional<std::uint32_t>& start, Position& position,
                 const io::Module& module) {
  const auto address = table.number(key, 0, 65'535);
  if (!address) return;
  if (has) {
    start = *address;
    position = table.at(key);
  } else {
    table.problems().add(ProblemCode::P0735, table.placeOf(key), module.title(), what);
  }
}

void readCable(const Table& table, io::Module& module) {
  if (!table.has("cable")) return;
  if (module.type->kind != ModuleKind::Interface) {
    table.problems().add(ProblemCode::P0735, table.placeOf("cable"), module.title(),
                         "cable; only interface modules have one");
    return;
  }
  const auto text = table.text("cable", "a length: \"5m\"");
  if (!text) return;
  module.cable = io::parseMetres(*text);
  module.cablePosition = table.at("cable");
  if (!module.cable) table.mustBe("cable", "a length: \"5m\"");
}

}  // namespace

std::string slotText(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{:.1f}", number->get());
  const auto* text = node.as_string();
  return text == nullptr ? std::string() : text->get();
}

namespace {

void allowKeys(const Table& table) {
  std::vector<std::string_view> keys{"slot",        "rack",       "type",    "name",
                                     "input",       "output",     "cable",   "input_delay",
                                     "rising_edge", "range",      "on_stop", "falling_edge",
                                     "diagnostics", "substitute", "channel", "interrupts",
                                     "serial",      "slave",      "web"};
  const toml::node* slot = table.node("slot");
  if (slot != nullptr && slotText(*slot) == "2.5")
    keys.insert(keys.end(), axisKeys().begin(), axisKeys().end());
  table.allow(keys);
}

}  // namespace

std::optional<io::Module> readModule(const Table& table, const CpuModel& model) {
  allowKeys(table);
  io::Module module;
  module.position = table.place();
  if (!readPlace(table, model, module)) return std::nullopt;
  if (const auto name = table.text("name", "a text")) {
    module.name = *name;
    if (name->empty()) table.mustBe("name", "a text of at least one character");
  }
  if (module.type->kind == ModuleKind::PointToPoint && module.name.empty()) module.name = "X27";
  readAddress(table, "input", module.type->hasInputs(), "inputs", module.inputStart,
              module.inputPosition, module);
  readAddress(table, "output", module.type->hasOutputs(), "outputs", module.outputStart,
              module.outputPosition, module);
  readCable(table, module);
  module.parameters = io::Parameters::of(*module.type);
  readParameters(table, module);
  readInterruptSelection(table, module);
  if (module.type->kind == ModuleKind::Counting) readCounters(table, model, module);
  if (module.type->kind == ModuleKind::Positioning) readAxis(table, module);
  readSerial(table, model, module);
  readAsiSlaves(table, module);
  readCpWeb(table, module);
  return module;
}

}  // namespace merker::project
