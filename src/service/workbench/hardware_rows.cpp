#include "workbench/hardware_rows.h"

#include "catalogue/communication.h"
#include "io/amount.h"
#include "monitor/symbol_name.h"

namespace merker::workbench {
namespace {

constexpr io::FaultKind kFaults[] = {
    io::FaultKind::Removed,      io::FaultKind::LoadVoltage,  io::FaultKind::WireBreak,
    io::FaultKind::ShortCircuit, io::FaultKind::SensorSupply, io::FaultKind::Fuse,
    io::FaultKind::RackPower,    io::FaultKind::Defect,       io::FaultKind::ParameterError};

Json rangeOf(std::optional<std::uint32_t> first, unsigned bytes) {
  if (!first || bytes == 0) return nullptr;
  return {{"first", *first}, {"bytes", bytes}};
}

// One side of a module's terminals: DI3 is E 0.3, AI1 is PEW 258.
struct Side {
  std::string_view text, bit, word;
  Area area;
  bool output;
};
constexpr Side kInputs{"I", "E", "PEW", Area::Input, false};
constexpr Side kOutputs{"O", "A", "PAW", Area::Output, true};

void addTerminals(Json& list, const Side& side, std::uint32_t start, unsigned digital,
                  unsigned analog, const source::SymbolTable& symbols) {
  const auto add = [&](std::string text, std::string operand, const address::Operand& key) {
    const source::Symbol* symbol = monitor::findSymbol(key, side.output, symbols);
    list.push_back({{"text", std::move(text)},
                    {"operand", std::move(operand)},
                    {"symbol", symbol == nullptr ? "" : symbol->name}});
  };
  for (unsigned i = 0; i < digital; ++i)
    add(fmt::format("D{}{}", side.text, i), fmt::format("{} {}.{}", side.bit, start + i / 8, i % 8),
        address::memory(side.area, Width::Bit, 8 * start + i));
  for (unsigned i = 0; i < analog; ++i)
    add(fmt::format("A{}{}", side.text, i), fmt::format("{} {}", side.word, start + 2 * i),
        address::memory(Area::Peripheral, Width::Word, 8 * (start + 2 * i)));
}

Json terminalsOf(const io::Module& module, const source::SymbolTable& symbols) {
  Json list = Json::array();
  const ModuleType& type = *module.type;
  if (module.inputStart)
    addTerminals(list, kInputs, *module.inputStart, type.digitalInputs, type.analogInputs, symbols);
  if (module.outputStart)
    addTerminals(list, kOutputs, *module.outputStart, type.digitalOutputs, type.analogOutputs,
                 symbols);
  return list;
}

// "0, 1": the inputs of these bits.
std::string inputsText(std::uint32_t bits) {
  std::string list;
  for (unsigned i = 0; i < 32; ++i)
    if ((bits >> i & 1) != 0) list += fmt::format("{}{}", list.empty() ? "" : ", ", i);
  return list.empty() ? "-" : list;
}

std::string edgesText(const io::Parameters& parameters) {
  if ((parameters.risingEdges | parameters.fallingEdges) == 0) return "off";
  return fmt::format("rising {}, falling {}", inputsText(parameters.risingEdges),
                     inputsText(parameters.fallingEdges));
}

Json propertiesOf(const io::Module& module) {
  const ModuleType& type = *module.type;
  const io::Parameters& parameters = module.parameters;
  Json list = Json::array();
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) list.push_back({name, value});
  };
  add("type", module.title());
  add("order number", std::string(type.orderNumber));
  add("slot", module.slotText());
  // Of an analog module it is what supplies it; what it measures each channel says.
  add(type.kind == ModuleKind::Digital ? "signal" : "supply", std::string(type.signal));
  if (type.busCurrent != 0) add("bus current", fmt::format("{} mA", type.busCurrent));
  if (type.digitalInputs != 0) add("input delay", io::formatLength(parameters.inputDelay));
  if (type.resolution != 0) add("resolution", fmt::format("{} bits", type.resolution));
  if (type.interruptChannels != 0) add("hardware interrupt", edgesText(parameters));
  if (type.diagnosticInterrupt)
    add("diagnostic interrupt", parameters.diagnosticInterrupt ? "on" : "off");
  if (module.web) add("port of the web server", std::to_string(module.web->port));
  return list;
}

Json faultsOf(const io::Module& module, const io::Rack* rack) {
  Json list = Json::array();
  const auto index = rack == nullptr ? std::nullopt : rack->module(module.slotText());
  if (!index) return list;
  for (const io::FaultKind kind : kFaults) {
    if (!io::possible(*module.type, kind)) continue;
    const std::string_view words = io::nameOf(kind).words;
    list.push_back({{"name", words}, {"title", words}, {"on", rack->hasAnywhere(*index, kind)}});
  }
  return list;
}

}  // namespace

Json moduleRow(const io::Module& module, const io::Rack* rack, const source::SymbolTable& symbols) {
  const ModuleType& type = *module.type;
  const auto index = rack == nullptr ? std::nullopt : rack->module(module.slotText());
  Json row = {{"slot", module.slotText()},
              {"order", type.orderNumber},
              {"name", module.name.empty() ? module.title() : module.name},
              {"type", module.title()},
              {"kind", kindOf(type.kind)},
              {"inputs", rangeOf(module.inputStart, type.inputBytes)},
              {"outputs", rangeOf(module.outputStart, type.outputBytes)},
              {"terminals", terminalsOf(module, symbols)},
              {"properties", propertiesOf(module)},
              {"faults", faultsOf(module, rack)},
              {"present", !index || rack->present(*index)}};
  if (type.diagnosticInterrupt && index)
    row["leds"] = {{"SF", rack->faulty(*index) ? "on" : "off"}};
  return row;
}

Json cpuRow(std::string_view order, std::string_view name, Json properties) {
  return {{"slot", "2"},
          {"order", order},
          {"name", name},
          {"type", name},
          {"kind", "cpu"},
          {"inputs", nullptr},
          {"outputs", nullptr},
          {"terminals", Json::array()},
          {"properties", std::move(properties)},
          {"faults", Json::array()},
          {"present", true}};
}

namespace {

// Braces alone would make an object of a list of pairs.
Json pair(const char* name, std::string value) { return Json::array({name, std::move(value)}); }

// Whatever it has on board.
Json rowOf(const CpuModel& model) {
  return cpuRow(model.orderNumber, model.name,
                Json::array({pair("work memory", fmt::format("{} bytes", model.workMemory)),
                             pair("timers", std::to_string(model.timers)),
                             pair("counters", std::to_string(model.counters)),
                             pair("flags", fmt::format("{} bytes", model.flagBytes))}));
}

}  // namespace

std::string_view kindOf(ModuleKind kind) {
  constexpr std::string_view kNames[] = {
      "power supply", "interface",     "digital",  "analog",      "position",
      "function",     "communication", "counting", "positioning", "point to point"};
  static_assert(std::size(kNames) == static_cast<std::size_t>(ModuleKind::PointToPoint) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

Json hardwareRows(const io::Configuration& configuration, const io::Rack* rack,
                  const source::SymbolTable& symbols) {
  Json racks = Json::array();
  for (std::uint32_t number = 0; number < configuration.model->racks; ++number) {
    Json slots = Json::array();
    bool cpu = number != 0;
    const auto addCpu = [&] {
      if (!cpu) slots.push_back(rowOf(*configuration.model));
      cpu = true;
    };
    for (const io::Module& module : configuration.modules) {
      if (module.rack != number) continue;
      if (module.slot >= 2) addCpu();
      slots.push_back(moduleRow(module, rack, symbols));
    }
    addCpu();
    if (!slots.empty()) racks.push_back({{"rack", number}, {"slots", std::move(slots)}});
  }
  return racks;
}

}  // namespace merker::workbench
