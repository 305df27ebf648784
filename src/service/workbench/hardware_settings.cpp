#include "workbench/hardware_settings.h"

#include <algorithm>

#include "workbench/parameter_rows.h"

namespace merker::workbench {
namespace {

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

}  // namespace

void addSettings(const project::Project& project, const io::Configuration& hardware, Json& racks) {
  addModules(hardware, *project.model, racks);
  for (Json& slot : racks[0]["slots"])
    if (slot["kind"] == "cpu") addCpuParameters(project, slot["properties"]);
}

}  // namespace merker::workbench
