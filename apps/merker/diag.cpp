// merker diag PATH [--for TIME]: run, then show what a programming device shows of the CPU.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "build.h"
#include "chosen_scenario.h"
#include "command.h"
#include "cpu_option.h"
#include "listing_diagnosis.h"
#include "monitor_text.h"
#include "operands.h"
#include "plc/checked_start.h"
#include "real_time.h"
#include "s7_desk.h"
#include "s7_text.h"
#include "scenario/duration.h"
#include "scenario/junit.h"
#include "scenario/runner.h"
#include "scenario/start.h"

namespace merker::app {
namespace {

struct DiagOptions {
  ProjectOptions project;
  std::string path, time = "10s", scenario, name;
  std::uint32_t line = 0;
  bool json = false;
  std::vector<std::string> set;
  S7Option s7;
};

void printBuffer(const monitor::Monitor& monitor) {
  std::cout << informationText(monitor.information());
  std::cout << "\nDiagnostic buffer, newest first\n"
            << diagnosticsText(monitor.diagnostics(), SIZE_MAX);
}

void printStacks(const monitor::Monitor& monitor) {
  const monitor::Stacks stacks = monitor.stacks();
  if (stacks.empty()) return;
  std::cout << "\nB stack\n"
            << blockStackText(stacks) << "\nI stack\n"
            << interruptStackText(stacks);
  if (!stacks.locals.empty()) std::cout << "\nL stack\n" << localStackText(stacks);
}

// `screens` have their own history: alarms by number, oldest first.
void printJson(const monitor::Monitor& monitor, const nlohmann::ordered_json& screens) {
  nlohmann::ordered_json document = {{"module", toJson(monitor.information())},
                                     {"diagnostics", toJson(monitor.diagnostics())},
                                     {"stacks", toJson(monitor.stacks())}};
  document.update(screens);
  std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

// In real time, with clients of S7 communication; who is connected at the end.
int runWithClients(const DiagOptions& options, const Build& built, Duration time,
                   controller::Controller& plc, workbench::S7Outside& outside) {
  const auto monitor = monitor::monitorOf(plc, built.project.symbols, built.resolver());
  holdSignals();
  Bell bell;  // outlives the server
  S7Desk s7;
  const auto wake = [&bell] { bell.ring(); };
  if (const int bad = s7.open("merker diag", options.s7, built.project.communication, wake))
    return bad;
  plc.onCycle(s7.cycleObserver(*monitor));
  const Guests guests{.slice = [&] { s7.exchange(*monitor); },
                      .waiting = [&] { return s7.waits(); },
                      .bell = &bell};
  runRealTime(plc, nullptr, guests, plc.now() + time);
  plc.onCycle({});
  outside = s7.outside();
  releaseSignals();
  return kGood;
}

// Starts, sets and runs. A start that is refused stands in the diagnostic buffer.
int runFor(const DiagOptions& options, const Build& built, Duration time,
           controller::Controller& plc, workbench::S7Outside& outside) {
  std::vector<simulator::Assignment> assignments;
  const int wrong = readAssignments("--set", options.set, built.resolver(), assignments);
  if (wrong != kGood) return wrong;
  simulator::startFresh(plc, std::min(time, simulator::kLongestStartup));
  for (const simulator::Assignment& one : assignments) {
    const std::string reason = simulator::apply(one, false, plc);
    if (reason.empty()) continue;
    std::cerr << "merker diag: --set: " << reason << '\n';
    return kUsage;
  }
  if (!options.s7.place.empty()) {
    if (const int bad = runWithClients(options, built, time, plc, outside)) return bad;
  } else if (plc.mode() != controller::Mode::Startup) {
    plc.advanceTo(plc.now() + time);
  }
  plc.settle();
  return kGood;
}

// Up to its STOP, or to the step of a line.
int runScenario(const DiagOptions& options, const Build& built, controller::Controller& plc) {
  int code = kGood;
  const auto chosen = chooseScenario("merker diag", options.scenario, options.name, built, code);
  if (!chosen) return code;
  const auto result = simulator::runUntil(chosen->scenario, {options.line}, plc);
  for (const simulator::Failure& failure : result.failures)
    std::cerr << "merker diag: " << simulator::describe(failure) << '\n';
  return kGood;
}

int carryOut(const DiagOptions& options, const Build& built, Duration time,
             controller::Controller& plc, workbench::S7Outside& outside) {
  return options.scenario.empty() ? runFor(options, built, time, plc, outside)
                                  : runScenario(options, built, plc);
}

// Of a PLC that checks its start, one that does not end is a failure (as in `merker run`).
int endCode(const controller::Controller& plc) {
  if (plc.stoppedByFault()) return kFault;
  const bool checked = controller::capability<controller::CheckedStart>(plc) != nullptr;
  return checked && plc.mode() == controller::Mode::Startup ? kProblems : kGood;
}

// `control`: the same machine, if it is a SINUMERIK; it has screens of its own for its state.
int show(const DiagOptions& options, const Build& built, Duration time, controller::Controller& plc,
         cnc::Cnc* control) {
  const auto monitor = monitor::monitorOf(plc, built.project.symbols, built.resolver());
  workbench::S7Outside outside;
  if (const int wrong = carryOut(options, built, time, plc, outside); wrong != kGood) return wrong;
  if (options.json) {
    auto more = control != nullptr ? diagnosisToJson(*control) : nlohmann::ordered_json::object();
    if (!outside.place.empty()) more["communication"] = workbench::s7Json(outside);
    printJson(*monitor, more);
  } else {
    control != nullptr ? printDiagnosis(*control) : printBuffer(*monitor);
    printStacks(*monitor);
    if (!outside.place.empty()) std::cout << '\n' << s7Text(outside);
  }
  return endCode(plc);
}

int diag(const DiagOptions& options) {
  const auto time = simulator::parseDuration(options.time);
  if (!time) {
    std::cerr << "merker diag: --for: '" << options.time
              << "' is not a valid duration; write 250ms, 7.5s, 2m or T#1S\n";
    return kUsage;
  }
  if (!options.s7.place.empty() && !options.scenario.empty()) {
    std::cerr << "merker diag: --s7 needs real time: leave --scenario out\n";
    return kUsage;
  }
  const Build built = build(loadProject(options.path, options.project), false);
  if (!built.ok()) return report(built, options.json);
  printProblems(built.problems, built.files());
  if (!built.isListing()) return show(options, built, *time, *built.controller(), nullptr);
  const auto control = built.control();
  return show(options, built, *time, *control, control.get());
}

}  // namespace

void addDiag(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "diag", "run in virtual time, then show state, diagnostic buffer and stacks of the CPU");
  auto options = std::make_shared<DiagOptions>();
  command->add_option("PATH", options->path, "project folder or source")->required();
  command->add_option("--for", options->time, "run this long: 250ms, 7.5s, 2m (default 10s)");
  command->add_option("--set", options->set, "before the start: \"E 0.0=1, MW 10=W#16#0005\"")
      ->allow_extra_args(false);
  command->add_option("--scenario", options->scenario,
                      "instead of --for and --set: run a scenario (*.scn) up to its STOP");
  command->add_option("--name", options->name, "the scenario whose name contains this text");
  command->add_option("--line", options->line, "end behind the step of this line, in STOP or not");
  addS7(*command, options->s7);
  addProjectOptions(*command, options->project);
  command->add_flag("--json", options->json, "as one JSON object");
  command->footer(
      "The B stack shows the blocks that ran when the CPU stopped, the I stack the registers of\n"
      "each priority class, the L stack local data.\n"
      "With --s7 it runs in real time and shows at last which clients are connected.\n"
      "Examples:\n"
      "  merker diag examples/sorting-plant\n"
      "  merker diag faulty.awl --for 1s --set \"E 0.7=1\" --json\n"
      "  merker diag faulty.s5 --scenario faulty.scn --name \"second edge\"");
  command->callback([options, &result] { result = diag(*options); });
}

}  // namespace merker::app
