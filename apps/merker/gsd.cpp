// merker gsd FILE...: what GSD files say of PROFIBUS-DP slaves.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/visible.h"
#include "command.h"
#include "gsd/configuration.h"
#include "gsd/parameters.h"
#include "gsd/read.h"
#include "input.h"
#include "output.h"

namespace merker::app {
namespace {

using nlohmann::json;

struct GsdOptions {
  std::vector<std::string> files;
  bool json = false;
};

struct GsdFile {
  std::string name, failure;  // why it could not be read
  gsd::Reading reading;
};

GsdFile readGsdFile(const std::string& name) {
  auto bytes = readBytes(name);
  if (!bytes) return {name, bytes.error().message, {}};
  if (bytes->size() > gsd::kLargestFile)
    return {name, "the file is larger than 1 MB; a GSD file of that size is not accepted", {}};
  return {name, {}, gsd::read(gsd::decode(name, std::move(*bytes)))};
}

std::string gsdBytes(const gsd::Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes)
    text += fmt::format("{}{:02X}", text.empty() ? "" : " ", byte);
  return text;
}

constexpr std::string_view kNoGsd = "this is not a GSD file: the line #Profibus_DP is missing";

void printGsdRemarks(const GsdFile& file) {
  const std::string name = visible(file.name);
  if (!file.failure.empty())
    std::cerr << fmt::format("{}: error: {}\n", name, file.failure);
  else if (!file.reading.isGsd)
    std::cerr << fmt::format("{}: error: {}\n", name, kNoGsd);
  for (const gsd::Remark& remark : file.reading.remarks) {
    std::string place = remark.line == 0 ? "" : fmt::format(":{}", remark.line);
    if (remark.column != 0) place += fmt::format(":{}", remark.column);
    std::cerr << fmt::format("{}{}: warning: {}\n", name, place, visible(remark.text));
  }
}

std::string gsdRates(const gsd::Device& device) {
  std::string list;
  for (const gsd::BaudRate& rate : device.rates)
    if (rate.supported) list += (list.empty() ? "" : ", ") + rate.name;
  return list.empty() ? "none" : list;
}

void printGsdModule(const gsd::Module& module, const gsd::Device& device) {
  const gsd::Areas areas = gsd::readIdentifiers(module.configuration);
  std::cout << fmt::format("  {:<40} {:>5} {:>6}  {}\n", visible(module.name), areas.input(),
                           areas.output(), gsdBytes(module.configuration));
  const gsd::Bytes parameters = gsd::standardParameters(module.parameters, device);
  if (!parameters.empty()) std::cout << fmt::format("    parameters: {}\n", gsdBytes(parameters));
}

void printGsdDevice(const GsdFile& file) {
  const gsd::Device& device = file.reading.device;
  std::cout << fmt::format("{}: {} {}, ident number 0x{:04X}, GSD revision {}\n",
                           visible(file.name), visible(device.vendor), visible(device.model),
                           device.ident, device.gsdRevision);
  std::cout << fmt::format("  baud rates: {}\n", gsdRates(device));
  if (device.modular)
    std::cout << fmt::format("  at most {} modules, {} bytes of inputs, {} of outputs\n",
                             device.maxModules, device.maxInput, device.maxOutput);
  const gsd::Bytes parameters = gsd::standardParameters(device.parameters, device);
  if (!parameters.empty()) std::cout << fmt::format("  parameters: {}\n", gsdBytes(parameters));
  std::cout << fmt::format("  {:<40} {:>5} {:>6}  configuration\n",
                           fmt::format("modules ({})", device.modules.size()), "input", "output");
  for (const gsd::Module& module : device.modules) printGsdModule(module, device);
}

json parameterJson(const gsd::UserParameters& used, const gsd::Device& device) {
  json parameters = json::array();
  for (const auto& reference : used.references) {
    const auto found =
        std::ranges::find(device.definitions, reference.parameter, &gsd::Parameter::number);
    if (found == device.definitions.end()) continue;
    json one{{"name", found->name},        {"offset", reference.offset},
             {"type", found->type},        {"bits", {found->firstBit, found->lastBit}},
             {"default", found->standard}, {"allowed", found->allowed}};
    const auto texts = found->text ? device.texts.find(*found->text) : device.texts.end();
    if (texts != device.texts.end())
      for (const auto& [value, text] : texts->second) one["texts"][std::to_string(value)] = text;
    parameters.push_back(std::move(one));
  }
  return parameters;
}

json gsdJson(const gsd::Module& module, const gsd::Device& device) {
  const gsd::Areas areas = gsd::readIdentifiers(module.configuration);
  json made{{"name", module.name},
            {"configuration", module.configuration},
            {"input", areas.input()},
            {"output", areas.output()},
            {"parameterBytes", gsd::standardParameters(module.parameters, device)},
            {"parameters", parameterJson(module.parameters, device)},
            {"line", module.line}};
  if (module.reference) made["reference"] = *module.reference;
  if (!module.info.empty()) made["info"] = module.info;
  if (module.preset) made["preset"] = true;
  return made;
}

json gsdJson(const gsd::Slot& slot) {
  json made{{"number", slot.number}, {"name", slot.name}, {"allowed", slot.allowed}};
  if (slot.standard) made["default"] = *slot.standard;
  return made;
}

json gsdJson(const gsd::Device& device) {
  json made{{"vendor", device.vendor},
            {"model", device.model},
            {"revision", device.revision},
            {"order", device.order},
            {"gsdRevision", device.gsdRevision},
            {"ident", device.ident},
            {"modular", device.modular},
            {"maxModules", device.maxModules},
            {"maxInput", device.maxInput},
            {"maxOutput", device.maxOutput},
            {"maxData", device.maxData},
            {"maxDiagnosis", device.maxDiagnosis},
            {"sync", device.sync},
            {"freeze", device.freeze},
            {"dpv1", device.dpv1},
            {"parameterBytes", gsd::standardParameters(device.parameters, device)},
            {"parameters", parameterJson(device.parameters, device)},
            {"baudRates", json::array()},
            {"modules", json::array()},
            {"slots", json::array()}};
  for (const gsd::BaudRate& rate : device.rates)
    if (rate.supported)
      made["baudRates"].push_back({{"rate", rate.rate}, {"maxTsdr", rate.maxTsdr}});
  for (const gsd::Module& module : device.modules)
    made["modules"].push_back(gsdJson(module, device));
  for (const gsd::Slot& slot : device.slots) made["slots"].push_back(gsdJson(slot));
  return made;
}

json gsdJson(const GsdFile& file) {
  json made{{"file", file.name}, {"remarks", json::array()}};
  for (const gsd::Remark& remark : file.reading.remarks)
    made["remarks"].push_back(
        {{"line", remark.line}, {"column", remark.column}, {"message", remark.text}});
  if (!file.failure.empty())
    made["error"] = file.failure;
  else if (!file.reading.isGsd)
    made["error"] = kNoGsd;
  else
    made["device"] = gsdJson(file.reading.device);
  return made;
}

int showGsd(const GsdOptions& options) {
  int result = kGood;
  json document = json::array();
  for (const std::string& name : options.files) {
    const GsdFile file = readGsdFile(name);
    const int one = !file.failure.empty() ? kUnreadable : file.reading.isGsd ? kGood : kProblems;
    result = std::max(result, one);
    if (options.json) {
      document.push_back(gsdJson(file));
      continue;
    }
    printGsdRemarks(file);
    if (one == kGood) printGsdDevice(file);
  }
  if (options.json) print(document);
  return result;
}

}  // namespace

void addGsd(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "gsd", "what GSD files say of PROFIBUS-DP slaves: modules, bytes, baud rates, parameters");
  auto options = std::make_shared<GsdOptions>();
  command->add_option("FILE", options->files, "GSD files of any language: *.gsd, *.gse, *.gsg, ...")
      ->required();
  command->add_flag("--json", options->json, "as a list of objects, one for each file");
  command->footer(
      "Warnings are what a file does wrong; it is read as it must be meant.\n"
      "Examples:\n"
      "  merker gsd et200b.gsd\n"
      "  merker gsd gsd/*.gs? --json");
  command->callback([options, &result] { result = showGsd(*options); });
}

}  // namespace merker::app
