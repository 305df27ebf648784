#include "workbench/look.h"

#include <algorithm>

#include "block/container.h"
#include "workbench/hardware_rows.h"
#include "workbench/parameter_rows.h"
#include "workbench/program_rows.h"
#include "workbench/symbol_rows.h"

namespace merker::workbench {
namespace {

// `source` is empty for a block that has none of its own.
Json blockTexts(const monitor::ProgramCode& code, const compilation::Build& build,
                Mnemonics mnemonics) {
  const project::Project& project = build.project;
  const auto sources = build.isListing() ? listingSources(project.sources)
                                         : blockSources(project.sources, project.symbols);
  Json rows = Json::array();
  for (const monitor::BlockCode& block : code.blocks()) {
    const auto source = sources.find(block.id());
    const bool s7 = block.s7() != nullptr;
    rows.push_back({{"id", toString(block.id())},
                    {"code", listing(block, mnemonics)},
                    {"checksum", s7 ? fmt::format("{:04X}", checksum(*block.s7())) : ""},
                    {"source", source == sources.end() ? "" : source->second.text}});
  }
  return rows;
}

Json symbolTexts(const source::SymbolTable& symbols) {
  Json rows = Json::array();
  for (const source::Symbol& symbol : symbols.list())
    rows.push_back(toJson(symbolRow(symbol, symbols.language())));
  return rows;
}

// As a property of a module: "on", "150ms", "2", "0, 1".
std::string valueText(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string list;
  for (const Json& one : value) list += (list.empty() ? "" : ", ") + valueText(one);
  return list.empty() ? "-" : list;
}

// "" for what is set on the CPU itself, "OB 35 " for [cpu.OB35].
std::string ownerOf(const std::string& table) {
  constexpr std::string_view kBlock = "cpu.OB";
  return table.starts_with(kBlock) ? "OB " + table.substr(kBlock.size()) + " " : "";
}

// What is set on the CPU, by the keys of merker.toml. A password is not for everybody who looks.
void addCpuParameters(const project::Project& project, Json& properties) {
  for (const Json& table : cpuParameterRows(project))
    for (const Json& parameter : table["parameters"]) {
      const auto key = parameter["key"].get<std::string>();
      if (key == "password" || parameter["value"].is_null()) continue;
      properties.push_back(Json::array(
          {ownerOf(table["table"].get<std::string>()) + key, valueText(parameter["value"])}));
    }
}

// What `propertiesOf` or the columns of a comparison say already.
bool isSaid(std::string_view key) {
  constexpr std::string_view kSaid[] = {"name",        "input",        "output",     "input_delay",
                                        "rising_edge", "falling_edge", "diagnostics"};
  return std::ranges::find(kSaid, key) != std::end(kSaid);
}

void addParameters(const Json& parameters, const std::string& owner, Json& properties) {
  for (const Json& parameter : parameters) {
    const auto key = parameter["key"].get<std::string>();
    const bool said = owner.empty() && isSaid(key);
    if (!parameter["value"].is_null() && !said)
      properties.push_back(Json::array({owner + key, valueText(parameter["value"])}));
  }
}

// "input 0 ", of a counting channel "channel 0 ".
std::string channelOf(const Json& channel) {
  const auto side = channel["side"].get<std::string>();
  return fmt::format("{} {} ", side == "number" ? "channel" : side,
                     channel["number"].get<unsigned>());
}

// What is set on a module and on its channels: "input 0 range".
void addModuleParameters(const io::Module& module, const CpuModel& model, Json& properties) {
  addParameters(parameterRows(module), "", properties);
  for (const Json& channel : channelRows(module, model))
    addParameters(channel["parameters"], channelOf(channel), properties);
}

void addModules(const io::Configuration& configuration, const CpuModel& model, Json& racks) {
  for (const io::Module& module : configuration.modules)
    for (Json& rack : racks)
      for (Json& slot : rack["slots"])
        if (rack["rack"] == module.rack && slot["slot"] == module.slotText() &&
            slot["kind"] != "cpu")
          addModuleParameters(module, model, slot["properties"]);
}

// It has no modules that are chosen: the control, and its machine data unlike the standard ones.
Json controlRacks(const cnc::Options& control) {
  Json properties = Json::array();
  for (const cnc::MachineDatum& datum : control.machineData)
    properties.push_back(
        Json::array({fmt::format("MD {}", datum.number), std::to_string(datum.value)}));
  Json racks = Json::array();
  racks.push_back(
      {{"rack", 0},
       {"slots", Json::array({cpuRow("", control.model->name, std::move(properties))})}});
  return racks;
}

Json racksOf(const project::Project& project) {
  if (project.control) return controlRacks(*project.control);
  Problems none;
  const io::Configuration hardware =
      project.hardware ? *project.hardware : io::configure({}, *project.model, none);
  Json racks = hardwareRows(hardware, nullptr, project.symbols);
  addModules(hardware, *project.model, racks);
  for (Json& slot : racks[0]["slots"])
    if (slot["kind"] == "cpu") addCpuParameters(project, slot["properties"]);
  return racks;
}

}  // namespace

Json lookOf(const compilation::Build& build, const block::Program* program, Mnemonics mnemonics) {
  const project::Project& project = build.project;
  const monitor::ProgramCode code = build.isListing()    ? monitor::ProgramCode(build.listings)
                                    : program != nullptr ? monitor::ProgramCode(*program)
                                                         : monitor::ProgramCode(*build.program);
  return {{"name", project.name},
          {"blocks", blockTexts(code, build, mnemonics)},
          {"symbols", symbolTexts(project.symbols)},
          {"racks", racksOf(project)}};
}

}  // namespace merker::workbench
