// merker hw PATH
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "build.h"
#include "command.h"
#include "compilation/network.h"
#include "cpu_option.h"
#include "hw_drawing.h"
#include "project/usage.h"

namespace merker::app {
namespace {

struct HwOptions {
  ProjectOptions project;
  std::string path;
  bool json = false, catalogue = false;
};

// What is shown: the project's hardware or, without one, the CPU as it is delivered.
io::Configuration hardwareOf(const Build& build) {
  if (build.project.hardware) return *build.project.hardware;
  Problems none;
  return io::configure({}, *build.project.model, none);
}

void printUsage(const std::vector<project::Usage>& usages) {
  std::cout << "utilisation\n";
  for (const project::Usage& usage : usages)
    std::cout << fmt::format("  {:<17} {:>7} of {:>7} {:<6} {:>4} %{}\n", usage.resource,
                             usage.used, usage.possible, usage.unit, usage.percent(),
                             usage.withoutReserve() ? "  no expansion reserve" : "");
}

void printText(const Build& build) {
  const project::Project& project = build.project;
  std::cout << fmt::format("{}: {}\n", project.name, project.model->name);
  if (project.hardware)
    std::cout << (project.vertical ? "vertical mounting, 0 to 40 °C\n"
                                   : "horizontal mounting, 0 to 60 °C\n");  // S7-HW-19
  else
    std::cout << "no hardware configuration in merker.toml: E and A of the whole process image "
                 "answer\n";
  std::cout << '\n' << drawRacks(hardwareOf(build));
  printUsage(project::usage(*build.program, *project.model, project.hardware));
}

nlohmann::json range(std::optional<std::uint32_t> start, unsigned bytes) {
  if (!start) return nullptr;
  return {{"first", *start}, {"last", *start + bytes - 1}};
}

nlohmann::json moduleJson(const io::Module& module) {
  const ModuleType& type = *module.type;
  return {{"slot", module.slotText()},
          {"rack", module.rack},
          {"type", title(type)},
          {"order_number", type.orderNumber},
          {"name", module.name},
          {"inputs", range(module.inputStart, type.inputBytes)},
          {"outputs", range(module.outputStart, type.outputBytes)},
          {"bus_current_mA", type.busCurrent},
          {"placeholder", type.placeholder()}};
}

// The CPU stands in slot 2 of rack 0, whatever it has on board.
nlohmann::json cpuJson(const CpuModel& model) {
  return {{"slot", "2"},         {"rack", 0},
          {"type", model.name},  {"order_number", model.orderNumber},
          {"name", ""},          {"inputs", nullptr},
          {"outputs", nullptr},  {"bus_current_mA", 0},
          {"placeholder", false}};
}

nlohmann::json modulesOf(const io::Configuration& hardware, std::uint32_t rack) {
  nlohmann::json modules = nlohmann::json::array();
  bool cpu = rack != 0;
  const auto addCpu = [&] {
    if (!cpu) modules.push_back(cpuJson(*hardware.model));
    cpu = true;
  };
  for (const io::Module& module : hardware.modules) {
    if (module.rack != rack) continue;
    if (module.slot >= 2) addCpu();
    modules.push_back(moduleJson(module));
  }
  addCpu();
  return modules;
}

nlohmann::json racks(const io::Configuration& hardware) {
  nlohmann::json list = nlohmann::json::array();
  for (std::uint32_t rack = 0; rack < hardware.model->racks; ++rack) {
    nlohmann::json modules = modulesOf(hardware, rack);
    if (modules.empty() && rack > 0) continue;
    const io::Current current = io::current(hardware, rack);
    list.push_back({{"rack", rack},
                    {"bus_current_mA", current.taken},
                    {"bus_current_possible_mA", current.possible},
                    {"modules", modules}});
  }
  return list;
}

nlohmann::json usages(const std::vector<project::Usage>& list) {
  nlohmann::json document = nlohmann::json::array();
  for (const project::Usage& usage : list)
    document.push_back({{"resource", usage.resource},
                        {"used", usage.used},
                        {"possible", usage.possible},
                        {"percent", usage.percent()},
                        {"no_expansion_reserve", usage.withoutReserve()}});
  return document;
}

nlohmann::json stationJson(const Build& build) {
  const project::Project& project = build.project;
  return {{"name", project.name},
          {"cpu", project.model->name},
          {"configured", project.hardware.has_value()},
          {"mounting", project.vertical ? "vertical" : "horizontal"},
          {"racks", racks(hardwareOf(build))},
          {"utilisation", usages(project::usage(*build.program, *project.model, project.hardware))},
          {"problems", toJson(build.problems)}};
}

std::string channelsOf(const ModuleType& type) {
  std::string text;
  const auto add = [&](unsigned count, std::string_view kind) {
    if (count > 0) text += fmt::format("{}{}{}", text.empty() ? "" : " ", kind, count);
  };
  add(type.digitalInputs, "DI");
  add(type.digitalOutputs, "DO");
  add(type.analogInputs, "AI");
  add(type.analogOutputs, "AO");
  return text;
}

std::string abilities(const ModuleType& type) {
  std::string text;
  const auto add = [&](bool has, std::string_view word) {
    if (has) text += fmt::format("{}{}", text.empty() ? "" : ", ", word);
  };
  add(type.interruptChannels != 0, "hardware interrupt");
  add(type.diagnosticInterrupt, "diagnostic interrupt");
  add(type.substituteValues, "substitute values");
  add(type.placeholder(), "address space only");
  return text;
}

int catalogue() {
  std::cout << fmt::format("{:<20} {:<11} {:<27} {:<9} {:<14} {:>4}  {}\n", "order number", "name",
                           "type", "channels", "signal", "mA", "can");
  for (const ModuleType& type : moduleTypes())
    std::cout << fmt::format("{:<20} {:<11} {:<27} {:<9} {:<14} {:>4}  {}\n", type.orderNumber,
                             type.name, type.text, channelsOf(type), type.signal, type.busCurrent,
                             abilities(type));
  return kGood;
}

// Of each station, a SINUMERIK has no racks.
void printText(const compilation::NetworkBuild& build) {
  for (const compilation::NamedBuild& station : build.stations) {
    std::cout << fmt::format("{}station {}\n", &station == &build.stations.front() ? "" : "\n",
                             station.name);
    if (station.build->isListing())
      std::cout << station.build->controller()->modelName() << '\n';
    else
      printText(*station.build);
  }
}

void printJson(const compilation::NetworkBuild& build) {
  nlohmann::json stations = nlohmann::json::object();
  for (const compilation::NamedBuild& station : build.stations)
    if (!station.build->isListing()) stations[station.name] = stationJson(*station.build);
  print({{"name", build.project.name},
         {"stations", std::move(stations)},
         {"problems", toJson(build.problems)}});
}

int hardwareOfAll(project::Project project, bool asJson) {
  const auto built = compilation::buildNetwork(std::move(project), false);
  printProblems(built.problems, built.files());
  asJson ? printJson(built) : printText(built);
  if (built.unreadable) return kUnreadable;
  return built.ok() ? kGood : kProblems;
}

int hardware(const HwOptions& options) {
  if (options.catalogue) return catalogue();
  project::Project project = loadProject(options.path, options.project);
  if (project.network) return hardwareOfAll(std::move(project), options.json);
  const Build built = build(std::move(project), false);
  if (built.isListing() && built.ok()) return refuseListing("hw");
  printProblems(built.problems, built.files());
  if (built.project.unreadable) return exitCode(built);
  options.json ? print(stationJson(built)) : printText(built);
  return exitCode(built);
}

}  // namespace

void addHw(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "hw", "the racks as a drawing: modules, addresses, current, utilisation");
  auto options = std::make_shared<HwOptions>();
  auto* path = command->add_option("PATH", options->path, "project folder or source");
  auto* list = command->add_flag("--catalogue", options->catalogue, "all modules a rack can hold");
  addProjectOptions(*command, options->project);
  command->add_flag("--json", options->json, "as one JSON object");
  path->excludes(list);
  command->footer("Examples:\n  merker hw examples/03-hardware\n  merker hw --catalogue");
  command->callback([options, &result] {
    if (options->path.empty() && !options->catalogue)
      throw CLI::RequiredError("PATH or --catalogue");
    result = hardware(*options);
  });
}

}  // namespace merker::app
