// merker run PATH [--for TIME | --cycles N]
#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "build.h"
#include "card.h"
#include "command.h"
#include "cpu_option.h"
#include "cycle_end.h"
#include "engine_option.h"
#include "input.h"
#include "network_run.h"
#include "operands.h"
#include "plc/checked_start.h"
#include "real_time.h"
#include "run_options.h"
#include "s7_desk.h"
#include "scenario/duration.h"
#include "scenario/trace.h"
#include "serial_desk.h"
#include "serial_option.h"
#include "serve.h"
#include "values.h"
#include "virtual_time.h"

namespace merker::app {
namespace {

struct Operands {
  std::vector<simulator::Assignment> set;
  simulator::Watched print, watch;
};

int wrongUsage(const std::string& text) {
  std::cerr << "merker run: " << text << '\n';
  return kUsage;
}

std::string checkCycles(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  if (digits && text.size() <= 10 && std::stoull(text) <= 1'000'000'000) return {};
  return "'" + text + "' is not a valid number of cycles; write an integer from 0 to 1000000000";
}

int cannotWrite(const std::string& file) {
  std::cerr << "merker run: cannot write " << file << ": " << std::strerror(errno) << '\n';
  return kUnreadable;
}

// Before the first cycle: after the restart, which clears what is not retentive (S7-STATE-09).
bool applySet(const std::vector<simulator::Assignment>& assignments, controller::Controller& plc) {
  for (const simulator::Assignment& assignment : assignments) {
    const std::string reason = simulator::apply(assignment, false, plc);
    if (reason.empty()) continue;
    std::cerr << "merker run: --set: " << reason << '\n';
    return false;
  }
  return true;
}

void printJson(const Operands& operands, const controller::Controller& plc) {
  nlohmann::ordered_json document;
  addState(plc, document);
  addValues(operands.print, plc, document);
  std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

// Cycle monitoring does not watch the startup (S7-STATE-11), so that the real CPU would hang, too.
bool cyclesMissing(const RunOptions& options, const controller::Controller& plc) {
  const bool starting = plc.mode() == controller::Mode::Startup;
  if (starting)
    std::cerr << "merker run: the CPU is still in STARTUP: its startup OB has not ended after "
              << simulator::formatTime(plc.now()) << '\n';
  const auto* checked = controller::capability<controller::CheckedStart>(plc);
  if (checked != nullptr && checked->startFailed()) return true;
  return options.hasCycles && plc.mode() != controller::Mode::Stop && plc.cycles() < options.cycles;
}

int finish(const RunOptions& options, const Operands& operands, const controller::Controller& plc) {
  options.json ? printJson(operands, plc) : printValues(operands.print, plc);
  const bool all = allExist(operands.print.operands, plc);
  if (!plc.stoppedByFault()) return cyclesMissing(options, plc) || !all ? kProblems : kGood;
  std::cerr << "merker run: the CPU went to STOP: " << plc.stopReason() << '\n';
  return kFault;
}

int readOptions(const RunOptions& options, const Build& build, Operands& operands) {
  const auto resolver = build.resolver();
  const io::Configuration* hardware = build.project.hardware ? &*build.project.hardware : nullptr;
  const auto watched = [&](const char* option, const auto& texts, simulator::Watched& list) {
    return readWatched(option, texts, resolver, build.project.plants, hardware, list);
  };
  return std::max({readAssignments("--set", options.set, resolver, operands.set),
                   watched("--print", options.print, operands.print),
                   watched("--watch", options.watch, operands.watch)});
}

void advance(const RunOptions& options, controller::Controller& plc, std::optional<Duration> time,
             SerialLink* link) {
  if (time)
    runFor(plc, *time, link);
  else if (options.hasCycles)
    runCycles(plc, options.cycles);
  else
    runRealTime(plc, link);
}

int failed(const Problem& problem) {
  Problems problems;
  problems.add(problem);
  printProblems(problems, [](const std::string&) { return nullptr; });
  return kUnreadable;
}

std::optional<Problem> start(const Build& build, store::MemoryCard* card,
                             controller::Controller& plc) {
  if (card != nullptr) return switchOn(*card, build, plc);
  plc.memoryReset();
  plc.start();
  return std::nullopt;
}

// What stands at the end of a run, whoever moved time.
int conclude(const RunOptions& options, const Build& build, const Operands& operands,
             store::MemoryCard* card, CycleEnd& cycleEnd, controller::Controller& plc,
             bool realTime) {
  // Whoever ends a run in real time does not wait for a cycle or a startup that has no end.
  constexpr Duration kLongest = Duration::seconds(1);
  if (realTime && plc.mode() == controller::Mode::Startup)
    plc.advanceToCheckpoint(plc.now() + kLongest);
  plc.settle(realTime ? kLongest : controller::Controller::kLongestCycle);
  cycleEnd(plc);
  if (cycleEnd.problem() != nullptr) return failed(*cycleEnd.problem());
  if (options.copyRamToRom)
    if (auto* memory = controller::capability<cpu::RamToRom>(plc))
      if (const auto problem = copyRamToRom(*card, build, plc, *memory)) return failed(*problem);
  return finish(options, operands, plc);
}

// Of the command line, else of merker.toml.
S7Option s7Of(const RunOptions& options, const Build& build) {
  if (!options.serve.s7.place.empty()) return options.serve.s7;
  return {build.project.communication.address};
}

// The workbench has the PLC until Ctrl-C. Nothing is left to say of it if another one is open then.
int runServed(const RunOptions& options, const Build& build, const Operands& operands,
              store::MemoryCard* card, CycleEnd& cycleEnd,
              std::unique_ptr<controller::Controller> owner, std::unique_ptr<SerialLink> link) {
  controller::Controller* plc = owner.get();
  workbench::Workbench workbench;
  workbench.show(std::make_unique<workbench::Plc>(build, std::move(owner)));
  if (cycleEnd.needed()) workbench.plc()->onCycle(std::ref(cycleEnd));
  ServeOptions serving = options.serve;
  serving.project = options.path;
  serving.s7 = s7Of(options, build);
  SerialDesk serial(workbench, build.project.serial);
  serial.use(std::move(link));
  if (const int code = serve("merker run", serving, workbench, options.json, serial)) return code;
  if (workbench.plc() == nullptr || &workbench.plc()->controller() != plc) return kGood;
  return conclude(options, build, operands, card, cycleEnd, *plc, true);
}

// In real time, with clients of S7 communication.
void advanceServed(const Build& build, CycleEnd& cycleEnd, controller::Controller& plc,
                   SerialLink* link, S7Desk& s7, Bell& bell) {
  const auto monitor = monitor::monitorOf(plc, build.project.symbols, build.resolver());
  plc.onCycle([&, served = s7.cycleObserver(*monitor)](controller::Controller& moved) {
    if (cycleEnd.needed()) cycleEnd(moved);
    served(moved);
  });
  const auto slice = [&] {
    s7.exchange(*monitor);
    cycleEnd.standing(plc);
  };
  runRealTime(plc, link, {.slice = slice, .waiting = [&] { return s7.waits(); }, .bell = &bell});
  plc.onCycle([&](controller::Controller& moved) { cycleEnd(moved); });
}

int runAlone(const RunOptions& options, const Build& build, const Operands& operands,
             std::optional<Duration> time, store::MemoryCard* card, CycleEnd& cycleEnd,
             controller::Controller& plc, SerialLink* link) {
  // A card keeps each cycle; a trace shows changes only.
  if (cycleEnd.needed())
    cycleEnd.ofChanges() ? plc.onChange(std::ref(cycleEnd)) : plc.onCycle(std::ref(cycleEnd));
  const bool realTime = !time && !options.hasCycles;
  if (realTime) holdSignals();
  Bell bell;  // outlives the server
  S7Desk s7;
  const S7Option wanted = realTime ? s7Of(options, build) : S7Option{};
  const auto wake = [&bell] { bell.ring(); };
  if (const int bad = s7.open("merker run", wanted, build.project.communication, wake)) return bad;
  if (s7.isOpen())
    advanceServed(build, cycleEnd, plc, link, s7, bell);
  else
    advance(options, plc, time, link);
  return conclude(options, build, operands, card, cycleEnd, plc, realTime);
}

int runPlc(const RunOptions& options, const Build& build, const Operands& operands,
           std::optional<Duration> time, store::MemoryCard* card) {
  auto owner = build.controller();
  controller::Controller& plc = *owner;
  if (const auto problem = useEngine(options.engine, plc, !time && !options.hasCycles))
    return wrongUsage(*problem);
  useSkipping(options.noSkip, plc);
  if (const auto problem = start(build, card, plc)) return failed(*problem);
  if (plc.mode() == controller::Mode::Stop) {
    std::cerr << "merker run: the CPU does not start: " << plc.stopReason() << '\n';
    return kFault;
  }
  if (!applySet(operands.set, plc)) return kUsage;
  std::unique_ptr<SerialLink> link;
  const bool virtualTime = time || options.hasCycles;
  if (const int bad = openSerial(options.serial, build, virtualTime, plc, link)) return bad;
  std::ofstream file;
  CycleEnd cycleEnd(card, file, !time && !options.hasCycles);
  if (!options.trace.empty()) {
    file.open(options.trace, std::ios::binary);
    if (!file) return cannotWrite(options.trace);
    cycleEnd.watch(operands.watch, plc);
  }
  const bool alone = time || options.hasCycles || options.noWorkbench;
  const int result =
      alone
          ? runAlone(options, build, operands, time, card, cycleEnd, plc, link.get())
          : runServed(options, build, operands, card, cycleEnd, std::move(owner), std::move(link));
  file.close();
  return options.trace.empty() || file ? result : cannotWrite(options.trace);
}

int runBuild(const RunOptions& options, Build& built, std::optional<Duration> time,
             store::MemoryCard* card) {
  Operands operands;
  if (const int bad = readOptions(options, built, operands); bad != kGood) return bad;
  return runPlc(options, built, operands, time, card);
}

// False: the problems are told.
bool ready(const RunOptions& options, Build& built) {
  requireOb1(built);
  requireWorkMemory(built);
  if (!built.ok()) report(built, options.json);
  if (built.ok()) printProblems(built.problems, built.files());
  return built.ok();
}

// What is wanted and this PLC cannot do; empty if it can.
std::string whyRefused(const RunOptions& options, const Build& built) {
  if (!options.copyRamToRom) return {};
  const auto plc = built.controller();
  if (controller::capability<cpu::RamToRom>(*plc) != nullptr) return {};
  return "--copy-ram-to-rom: " + plc->modelName() + " has no " + std::string(cpu::RamToRom::kName);
}

// A program that cannot run does not touch the card (S7-CPU-02: the old one stays).
int runPath(const RunOptions& options, std::optional<Duration> time) {
  project::Project project = loadProject(options.path, options.project);
  if (project.network) return runNetwork(options, std::move(project), time);
  if (options.threads) return wrongUsage("--threads is for a project of several stations");
  if (const int bad = connectSerial(options.serial, project); bad != kGood) return bad;
  Build built = build(std::move(project), false);
  if (!ready(options, built)) return exitCode(built);
  if (options.card.empty()) return runBuild(options, built, time, nullptr);
  if (const auto why = whyRefused(options, built); !why.empty()) return wrongUsage(why);
  if (built.partner) return wrongUsage("--card: two coupled PLCs cannot share one card");
  auto card = openCard(options.card, false);
  if (!card) return failed(card.error());
  return runBuild(options, built, time, &*card);
}

int runFromCard(const RunOptions& options, std::optional<Duration> time) {
  auto card = openCard(options.card, true);
  if (!card) return failed(card.error());
  Build built = buildFromCard(*card, options.card, options.project.cpu);
  if (const int bad = connectSerial(options.serial, built.project); bad != kGood) return bad;
  if (!ready(options, built)) return exitCode(built);
  if (const auto why = whyRefused(options, built); !why.empty()) return wrongUsage(why);
  return runBuild(options, built, time, &*card);
}

int run(const RunOptions& options) {
  std::optional<Duration> time;
  if (!options.time.empty()) {
    time = simulator::parseDuration(options.time);
    if (!time)
      return wrongUsage("--for: '" + options.time +
                        "' is not a valid duration; write 250ms, 7.5s, 2m or T#1S");
  }
  if (options.trace.empty() != options.watch.empty())
    return wrongUsage("--trace and --watch must be used together");
  if (options.path.empty() && options.card.empty())
    return wrongUsage("PATH is missing; it is optional only with --card (program on the card)");
  if (!options.serve.s7.place.empty() && (time || options.hasCycles))
    return wrongUsage("--s7 needs real time: leave --for and --cycles out");
  if (options.copyRamToRom && options.card.empty())
    return wrongUsage("--copy-ram-to-rom needs --card");
  return options.path.empty() ? runFromCard(options, time) : runPath(options, time);
}

}  // namespace

void addRun(CLI::App& program, int& result) {
  auto* command =
      program.add_subcommand("run", "run a program in real time until Ctrl-C, or in virtual time");
  auto options = std::make_shared<RunOptions>();
  command->add_option("PATH", options->path,
                      "project folder or source; with --card it may be left out");
  command->add_option("--card", options->card,
                      "folder that is the CPU's memory card: program and retentive data");
  command->add_flag("--copy-ram-to-rom", options->copyRamToRom,
                    "at the end, in STOP: actual values of data blocks become those of the card");
  auto* time = command->add_option("--for", options->time,
                                   "run this long in virtual time: 250ms, 7.5s, 2m, T#10S");
  auto* cycles =
      command->add_option("--cycles", options->cycles, "run this many cycles in virtual time");
  cycles->excludes(time)->check(checkCycles);
  addProjectOptions(*command, options->project);
  addEngine(*command, options->engine);
  addNoSkip(*command, options->noSkip);
  command->add_option("--set", options->set, "before the start: \"E 0.0=1, MW 10=W#16#0005\"")
      ->allow_extra_args(false);
  command->add_option("--print", options->print, "at the end: \"MW 10, A 0.0, DB1.DBD 4\"")
      ->allow_extra_args(false);
  command
      ->add_option("--watch", options->watch,
                   "operands, signals of plants, terminals to record: \"E 0.0, plant Oven.PV, "
                   "terminal 2.2.DO0\"")
      ->allow_extra_args(false);
  command->add_option("--trace", options->trace,
                      "file for --watch: time, operand, value of each change");
  command
      ->add_option("--threads", options->threads,
                   "for several stations: as many threads, with the same results")
      ->check(CLI::Range(1u, kMostThreads));
  addSerial(*command, options->serial);
  command->add_flag("--json", options->json, "the values at the end as one JSON object");
  command->add_flag("--no-workbench", options->noWorkbench,
                    "in real time without the workbench; ends when the CPU goes to STOP");
  addServe(*command, options->serve);
  command->footer(
      "Examples:\n"
      "  merker run examples/sorting-plant\n"
      "  merker run plant --card plant.card      (continues after a power failure)\n"
      "  merker run --card plant.card --for 1s   (the program that is on the card)\n"
      "  merker run blink.awl --for 10s --print \"A 0.0, MW 10\"\n"
      "  merker run lab --for 10s --print \"Press/MW 10, Belt/A 0.0\"   (several stations)\n"
      "  merker run plant --for 1m --set \"E 0.0=1\" --trace plant.csv --watch \"E 0.0, A 1.0\"");
  command->callback([options, cycles, &result] {
    options->hasCycles = cycles->count() > 0;
    result = run(*options);
  });
}

}  // namespace merker::app
