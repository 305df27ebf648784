// merker bench PATH --for TIME: how fast OB 1 runs on this machine. Wall clock, for measurements
// only.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "build.h"
#include "command.h"
#include "cpu_option.h"
#include "engine_option.h"
#include "plc/machine_code.h"
#include "plc/ob1_alone.h"
#include "quiet_reasons.h"
#include "scenario/duration.h"
#include "scenario/start.h"

namespace merker::app {
namespace {

using Clock = std::chrono::steady_clock;

struct BenchOptions {
  ProjectOptions project;
  std::string path, time = "1s", engine;
  bool json = false, why = false;
};

struct Measurement {
  double instructionsPerSecond = 0, cyclesPerSecond = 0, translationSeconds = 0;
  double seconds = 0;  // measured
  std::uint64_t cycles = 0;
};

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Looks at the clock once per portion only: the look must not cost more than a short OB 1.
void measure(controller::Controller& plc, controller::Ob1Alone& ob1, double seconds,
             Measurement& result) {
  constexpr int kPortion = 64;
  // A program that does not end its OB 1 comes back after this virtual time, too.
  constexpr Duration kLongest = Duration::milliseconds(1);
  const std::uint64_t before = plc.instructions();
  const auto start = Clock::now();
  do {
    for (int i = 0; i < kPortion; ++i) result.cycles += ob1.runOb1(kLongest) ? 1 : 0;
    result.seconds = secondsSince(start);
  } while (result.seconds < seconds && plc.mode() == controller::Mode::Run);
  result.instructionsPerSecond = static_cast<double>(plc.instructions() - before) / result.seconds;
  result.cyclesPerSecond = static_cast<double>(result.cycles) / result.seconds;
}

void show(const Measurement& m, bool json) {
  if (json) {
    print({{"instructions_per_second", m.instructionsPerSecond},
           {"cycles_per_second", m.cyclesPerSecond},
           {"translation_seconds", m.translationSeconds}});
    return;
  }
  std::cout << "instructions_per_second " << static_cast<std::uint64_t>(m.instructionsPerSecond)
            << '\n'
            << "cycles_per_second       " << static_cast<std::uint64_t>(m.cyclesPerSecond) << '\n'
            << "translation_seconds     " << m.translationSeconds << '\n';
}

// Machine code where it is wanted or, without a wish, possible, and how long making it took.
std::optional<std::string> translate(const std::string& engine, controller::Controller& plc,
                                     Measurement& result) {
  const auto start = Clock::now();
  auto* const code = controller::capability<controller::MachineCode>(plc);
  std::optional<std::string> problem;
  if (!engine.empty())
    problem = useEngine(engine, plc);
  else if (code != nullptr)
    (void)code->setCompiled(true);
  if (code != nullptr) code->translateNow();
  result.translationSeconds = secondsSince(start);
  return problem;
}

int stopped(const std::string& why) {
  std::cerr << "merker bench: " << why << '\n';
  return kFault;
}

// What the figures do not say.
void note(const Measurement& m, const BenchOptions& options, const controller::Controller& plc) {
  const auto* code = controller::capability<controller::MachineCode>(plc);
  if (options.engine == "jit" && code != nullptr && code->compiledBytes() == 0)
    std::cerr
        << "merker bench: this system does not allow machine code; the interpreter was used\n";
  if (plc.mode() != controller::Mode::Run && !plc.stoppedByFault())
    std::cerr << fmt::format(
        "merker bench: the program stopped the CPU after {} cycles, {:.3g} s: {}\n", m.cycles,
        m.seconds, plc.stopReason());
  else if (m.cycles == 0 && !plc.stoppedByFault())
    std::cerr << "merker bench: OB 1 did not end within this time\n";
}

int bench(const BenchOptions& options, controller::Controller& plc, double seconds) {
  auto* const ob1 = controller::capability<controller::Ob1Alone>(plc);
  if (ob1 == nullptr)
    return stopped(fmt::format("{} has no {}", plc.modelName(), controller::Ob1Alone::kName));
  Measurement result;
  if (const auto problem = translate(options.engine, plc, result)) {
    std::cerr << "merker bench: " << *problem << '\n';
    return kUsage;
  }
  if (const std::string reason = simulator::startFresh(plc); !reason.empty())
    return stopped(reason);
  measure(plc, *ob1, seconds, result);
  show(result, options.json);
  note(result, options, plc);
  return plc.stoppedByFault() ? stopped("the CPU went to STOP: " + plc.stopReason()) : kGood;
}

// A control works without OB 1, too; there is nothing to measure then.
bool lacksOb1(const Build& built) {
  return built.isListing() && !built.listings.contains({mc5::BlockType::Ob, 1});
}

int bench(const BenchOptions& options) {
  const auto time = simulator::parseDuration(options.time);
  if (!time) {
    std::cerr << "merker bench: --for: '" << options.time << "' is not a valid duration\n";
    return kUsage;
  }
  Build built = build(loadProject(options.path, options.project), false);
  requireOb1(built);
  requireWorkMemory(built);
  if (!built.ok()) return report(built, options.json);
  printProblems(built.problems, built.files());
  if (lacksOb1(built)) {
    std::cerr << "merker bench: " << options.path << ": the program has no OB 1 to measure\n";
    return kProblems;
  }
  if (options.why) {
    const std::string problem = tellWhy(built, *time);
    return problem.empty() ? kGood : stopped(problem);
  }
  return bench(options, *built.controller(), static_cast<double>(time->ns) / 1e9);
}

}  // namespace

void addBench(CLI::App& program, int& result) {
  auto* command = program.add_subcommand("bench", "run OB 1 back to back and measure the speed");
  auto options = std::make_shared<BenchOptions>();
  command->add_option("PATH", options->path, "project folder or source")->required();
  command->add_option("--for", options->time, "real time to measure: 250ms, 1s");
  addEngine(*command, options->engine);
  addProjectOptions(*command, options->project);
  command->add_flag(
      "--why", options->why,
      "instead: run so long in virtual time, and say which cycles had to be computed and "
      "why they are not the same as the one before");
  command->add_flag("--json", options->json, "as one JSON object");
  command->footer("Example:\n  merker bench examples/sorting-plant --for 2s --json");
  command->callback([options, &result] { result = bench(*options); });
}

}  // namespace merker::app
