// merker bench PATH --for TIME: how fast OB 1 runs on this machine. Wall clock, for measurements
// only.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "build.h"
#include "command.h"
#include "cpu_option.h"
#include "engine_option.h"
#include "simulator/duration.h"
#include "simulator/runner.h"

namespace merker::app {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  std::string path, cpu, time = "1s", engine = "interpreter";
  bool json = false;
};

struct Measurement {
  double instructionsPerSecond = 0, cyclesPerSecond = 0, translationSeconds = 0;
};

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Looks at the clock once per portion only: the look must not cost more than a short OB 1.
void measure(station::Station& station, double seconds, Measurement& result) {
  constexpr int kPortion = 64;
  // A program that does not end its OB 1 comes back after this virtual time, too.
  constexpr Duration kLongest = Duration::milliseconds(1);
  const std::uint64_t before = station.instructions();
  const auto start = Clock::now();
  std::uint64_t cycles = 0;
  double elapsed = 0;
  do {
    for (int i = 0; i < kPortion; ++i) cycles += station.runOb1(kLongest) ? 1 : 0;
    elapsed = secondsSince(start);
  } while (elapsed < seconds && station.mode() == station::Mode::Run);
  result.instructionsPerSecond = static_cast<double>(station.instructions() - before) / elapsed;
  result.cyclesPerSecond = static_cast<double>(cycles) / elapsed;
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

int bench(const Options& options) {
  const auto time = simulator::parseDuration(options.time);
  if (!time) {
    std::cerr << "merker bench: --for: '" << options.time << "' is no length of time\n";
    return kUsage;
  }
  Build built = build(project::load(options.path, options.cpu), false);
  if (built.isListing() && built.ok()) return refuseListing("bench");
  requireOb1(built);
  requireWorkMemory(built);
  if (!built.ok()) return report(built, options.json);
  printProblems(built.problems, built.files());
  Measurement result;
  const auto start = Clock::now();
  station::Station station = built.station();
  if (const auto problem = useEngine(options.engine, station)) {
    std::cerr << "merker bench: " << *problem << '\n';
    return kUsage;
  }
  result.translationSeconds = secondsSince(start);
  const std::string reason = simulator::startFresh(station);
  if (reason.empty()) {
    measure(station, static_cast<double>(time->ns) / 1e9, result);
    show(result, options.json);
    if (result.cyclesPerSecond == 0 && !station.stoppedByFault())
      std::cerr << "merker bench: OB 1 has not ended once in this time\n";
  }
  if (reason.empty() && !station.stoppedByFault()) return kGood;
  std::cerr << "merker bench: "
            << (reason.empty() ? "the CPU went to STOP: " + station.stopReason() : reason) << '\n';
  return kFault;
}

}  // namespace

void addBench(CLI::App& program, int& result) {
  auto* command = program.add_subcommand("bench", "run OB 1 back to back and measure the speed");
  auto options = std::make_shared<Options>();
  command->add_option("PATH", options->path, "project folder or source")->required();
  command->add_option("--for", options->time, "real time to measure: 250ms, 1s");
  addEngine(*command, options->engine);
  addCpu(*command, options->cpu);
  command->add_flag("--json", options->json, "as one JSON object");
  command->footer("Example:\n  merker bench examples/sorting-plant --for 2s --json");
  command->callback([options, &result] { result = bench(*options); });
}

}  // namespace merker::app
