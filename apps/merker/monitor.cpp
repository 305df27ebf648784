// merker monitor serial PATH: every character on the line of X27, with its time and what it means.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "build.h"
#include "chosen_scenario.h"
#include "command.h"
#include "cpu_option.h"
#include "engine_option.h"
#include "pcap.h"
#include "scenario/duration.h"
#include "scenario/junit.h"
#include "scenario/runner.h"
#include "scenario/start.h"
#include "serial/coupling.h"
#include "serial/decoder.h"
#include "serial/serial_port.h"
#include "serial_link.h"
#include "virtual_time.h"

namespace merker::app {
namespace {

struct MonitorOptions {
  ProjectOptions project;
  std::string path, time = "10s", scenario, name, csv, pcap, serial, engine;
};

int monitorFails(const std::string& text, ExitCode code) {
  std::cerr << "merker monitor serial: " << text << '\n';
  return code;
}

// What a scenario makes of the line, whether it fails or not; the exit code.
int playScenario(const MonitorOptions& options, const Build& built, controller::Controller& plc) {
  int code = kGood;
  const auto chosen =
      chooseScenario("merker monitor serial", options.scenario, options.name, built, code);
  if (!chosen) return code;
  for (const auto& failure : simulator::runScenario(chosen->scenario, plc).failures)
    std::cerr << "merker monitor serial: " << simulator::describe(failure) << '\n';
  return kGood;
}

// A program alone, or with a recording.
int playTime(const MonitorOptions& options, Duration time, controller::Controller& plc) {
  std::unique_ptr<SerialLink> link;
  if (!options.serial.empty()) {
    const auto connection = serial::parseConnection(options.serial);
    if (!connection || connection->kind != serial::Connection::Kind::Replay)
      return monitorFails("--serial: a recording is expected: replay:FILE", kUsage);
    std::string reason;
    link = SerialLink::open(*connection, {}, plc, reason);
    if (!reason.empty()) return monitorFails(reason, kUnreadable);
  }
  simulator::startFresh(plc, std::min(time, simulator::kLongestStartup));
  const Instant end = plc.now() + time;
  moveTo(plc, link.get(), end);
  return kGood;
}

constexpr const char* kEnds[] = {"X27", "partner"};

// A BREAK is no character.
std::string valueOf(const serial::Sighting& one) {
  return one.isCharacter() ? fmt::format("{:02X}", one.value) : "";
}

void printLine(const serial::Coupling& coupling) {
  const serial::Parameters& p = coupling.parameters();
  serial::Decoder decoder(p.protocol, p.procedure.blockCheck);
  if (coupling.seen() > coupling.sightings().size())
    std::cout << coupling.seen() - coupling.sightings().size()
              << " older characters are not shown\n";
  std::cout << "      begins         ends  from     character\n";
  for (const serial::Sighting& one : coupling.sightings())
    std::cout << fmt::format("{:>12} {:>12}  {:<7}  {:<2} {:<5} {}",
                             simulator::formatSeconds(one.start.ns, 6),
                             simulator::formatSeconds(one.end.ns, 6), kEnds[one.port], valueOf(one),
                             serial::nameOf(one), decoder.meaning(one))
              << '\n';
}

bool writeCapture(const serial::Coupling& coupling, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  writePcap(coupling.sightings(), file);
  file.close();
  return static_cast<bool>(file);
}

bool writeLine(const serial::Coupling& coupling, const std::string& path) {
  const serial::Parameters& p = coupling.parameters();
  serial::Decoder decoder(p.protocol, p.procedure.blockCheck);
  std::ofstream file(path, std::ios::binary);
  file << "begin_ns,end_ns,from,character,name,meaning,fault\n";
  for (const serial::Sighting& one : coupling.sightings()) {
    std::string name = serial::nameOf(one);
    if (name == "'\"'") name = "'\"\"'";
    file << fmt::format("{},{},{},{},\"{}\",\"{}\",{}\n", one.start.ns, one.end.ns, kEnds[one.port],
                        valueOf(one), name, decoder.meaning(one), serial::faultsOf(one));
  }
  file.close();
  return static_cast<bool>(file);
}

int cannotWriteLine(const std::string& path) {
  return monitorFails("cannot write " + path + ": " + std::strerror(errno), kUnreadable);
}

int monitorSerial(const MonitorOptions& options) {
  const auto time = simulator::parseDuration(options.time);
  if (!time) return monitorFails("--for: '" + options.time + "' is not a valid duration", kUsage);
  project::Project project = loadProject(options.path, options.project);
  if (!options.serial.empty()) project.stations.clear();
  const Build built = build(std::move(project), false);
  if (!built.ok()) return report(built, false);
  const auto plc = built.controller();
  if (const auto problem = useEngine(options.engine, *plc)) return monitorFails(*problem, kUsage);
  auto* port = controller::capability<serial::SerialPort>(*plc);
  if (port == nullptr || port->serial() == nullptr)
    return monitorFails("the project has no serial interface ([[module]] with slot = \"2.1\")",
                        kUsage);
  const int played = options.scenario.empty() ? playTime(options, *time, *plc)
                                              : playScenario(options, built, *plc);
  if (played != kGood) return played;
  const serial::Coupling& coupling = *port->serial();
  if (!options.csv.empty() && !writeLine(coupling, options.csv))
    return cannotWriteLine(options.csv);
  if (!options.pcap.empty() && !writeCapture(coupling, options.pcap))
    return cannotWriteLine(options.pcap);
  if (options.csv.empty() && options.pcap.empty()) printLine(coupling);
  return kGood;
}

}  // namespace

void addMonitor(CLI::App& program, int& result) {
  auto* monitor = program.add_subcommand("monitor", "watch what a program does outside its memory");
  monitor->require_subcommand(1);
  auto* command = monitor->add_subcommand(
      "serial", "every character on the line of X27 in virtual time, and what it means");
  auto options = std::make_shared<MonitorOptions>();
  command->add_option("PATH", options->path, "project folder")->required();
  auto* time = command->add_option("--for", options->time, "run this long (10s): 250ms, 7.5s, 2m");
  command->add_option("--scenario", options->scenario, "scenario that plays the partner")
      ->excludes(time);
  command->add_option("--name", options->name, "part of the scenario's name; without: the first");
  command->add_option("--csv", options->csv, "file for the characters, instead of the list");
  command->add_option("--pcap", options->pcap,
                      "the same as a capture file for network analysers (RTAC serial)");
  command->add_option("--serial", options->serial, "recording that plays the partner: replay:FILE");
  addProjectOptions(*command, options->project);
  addEngine(*command, options->engine);
  command->footer(
      "Examples:\n"
      "  merker monitor serial examples/technology/weighing-scale --scenario "
      "examples/technology/weighing-scale/scale.scn\n"
      "  merker monitor serial plant --for 1m --serial replay:line.csv --csv line-decoded.csv");
  command->callback([options, &result] { result = monitorSerial(*options); });
}

}  // namespace merker::app
