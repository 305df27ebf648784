// One CPU 314C with an ordinary program and nothing to do, and a thousand of them in one process:
// how much faster than real time, and how much memory.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "programs.h"
#include "together.h"

namespace merker::bench {
namespace {

using station::Engine;
using station::Station;

constexpr int kInstructions = 1000;

Station started(const std::shared_ptr<const block::Program>& program, Engine engine) {
  station::Options options;
  options.program = program;
  options.engine = engine;
  Station station(std::move(options));
  if (!station.warmRestart()) std::abort();
  return station;
}

void idle(benchmark::State& state, Engine engine, bool passOver) {
  const Duration kStep = passOver ? Duration::seconds(10) : Duration::milliseconds(100);
  Station station = started(compiled(controlSource(kInstructions), "314C-2 PtP"), engine);
  station.passOverQuietCycles(passOver);
  const Instant begin = station.now();
  for (auto _ : state) station.advanceTo(station.now() + kStep);
  state.SetItemsProcessed((station.now() - begin).ns);
}
void BusyCpu(benchmark::State& s) { idle(s, Engine::Interpreter, false); }
BENCHMARK(BusyCpu);
void BusyCpuCompiled(benchmark::State& s) { idle(s, Engine::Compiled, false); }
BENCHMARK(BusyCpuCompiled);
void IdleCpu(benchmark::State& s) { idle(s, Engine::Interpreter, true); }
BENCHMARK(IdleCpu);
void IdleCpuCompiled(benchmark::State& s) { idle(s, Engine::Compiled, true); }
BENCHMARK(IdleCpuCompiled);

// A small program that waits: a timer of a second that starts itself again, and what counts it.
void WeekOfATimer(benchmark::State& state) {
  constexpr const char* kSource =
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      U     T 1\n      ZV    Z 1\n      U     Z 1\n"
      "      =     A 0.0\n      UN    T 1\n      L     S5T#1S\n      SE    T "
      "1\nEND_ORGANIZATION_BLOCK\n";
  Station station = started(compiled(kSource, "314C-2 PtP"), Engine::Interpreter);
  for (auto _ : state) station.advanceTo(station.now() + Duration::seconds(7 * 24 * 3600));
}
BENCHMARK(WeekOfATimer)->UseRealTime()->Iterations(1);

// A cycle with everything the operating system does between two runs of OB 1.
void Cycles(benchmark::State& state) {
  station::Station station =
      started(compiled(callingSource(1, Callee::Function)), Engine::Interpreter);
  station.passOverQuietCycles(false);
  for (auto _ : state) station.advanceCycles(1);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(Cycles);

double residentBytes() {
  std::uint64_t total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// All of them together one virtual second.
void ThousandCpus(benchmark::State& state) {
  constexpr std::size_t kCpus = 1000;
  constexpr Duration kTime = Duration::seconds(1);
  const auto program = compiled(controlSource(kInstructions), "314C-2 PtP");
  const double before = residentBytes();
  Together stations(kCpus, [&] { return started(program, Engine::Compiled); });
  for (auto _ : state) stations.advance(kTime);
  state.SetItemsProcessed(state.iterations() * kTime.ns);
  state.counters["bytes"] = residentBytes() - before;
}
BENCHMARK(ThousandCpus)->UseRealTime()->Iterations(3);

}  // namespace
}  // namespace merker::bench
