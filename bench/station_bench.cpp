#include <benchmark/benchmark.h>

#include <cstdlib>

#include "programs.h"
#include "station/station.h"

namespace merker::bench {
namespace {

using station::Engine;

constexpr const char* kMixed =
    "      L     MW 12\n      L     MW 14\n      +I\n      L     2\n      *I\n      T     MW 14\n"
    "      L     MD 20\n      L     L#5\n      +D\n      T     MD 20\n"
    "      U     E 0.1\n      U     M 3.2\n      =     A 4.0\n"
    "      L     MW 14\n      L     100\n      >I\n      SPB   far\n"
    "      L     MW 12\n      +     1\n      T     MW 12\nfar:  NOP 0\n";
constexpr const char* kReals =
    "      L     MD 20\n      L     1.5\n      *R\n      L     2.5\n      -R\n"
    "      L     3.0\n      /R\n      L     MD 24\n      +R\n      T     MD 28\n";
constexpr const char* kIndirect =
    "      LAR1  P#M 10.0\n      L     W [AR1,P#0.0]\n      L     MW [MD 60]\n      +I\n"
    "      T     MW [AR1,P#8.0]\n      U     M [AR1,P#1.3]\n      =     A [AR1,P#0.1]\n"
    "      +AR1  P#2.0\n";
constexpr const char* kTimers =
    "      U     E 0.1\n      L     S5T#2S\n      SE    T 1\n      U     T 1\n      =     A 4.0\n"
    "      L     T 1\n      T     MW 30\n      U     E 0.2\n      ZV    Z 1\n      U     Z 1\n"
    "      =     A 4.1\n";

station::Station stationWith(const std::string& source, Engine engine = Engine::Interpreter) {
  station::Options options;
  options.model = findCpuModel("generic");
  options.program = compiled(source);
  options.engine = engine;
  station::Station station(std::move(options));
  if (!station.warmRestart()) std::abort();
  station.advanceCycles(1);  // through STARTUP
  return station;
}

void instructions(benchmark::State& state, const std::string& source, Engine engine) {
  station::Station station = stationWith(source, engine);
  const std::uint64_t before = station.instructions();
  for (auto _ : state) station.runOb1();
  const std::uint64_t count = station.instructions() - before;
  state.SetItemsProcessed(static_cast<std::int64_t>(count));
  state.counters["bytes_per_instruction"] =
      static_cast<double>(station.compiledBytes() * static_cast<std::size_t>(state.iterations())) /
      static_cast<double>(count);
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
}

void Instructions(benchmark::State& s) { instructions(s, mixedSource(), Engine::Interpreter); }
BENCHMARK(Instructions);
void InstructionsCompiled(benchmark::State& s) { instructions(s, mixedSource(), Engine::Compiled); }
BENCHMARK(InstructionsCompiled);

#define BOTH_ENGINES(name, source)                                                        \
  void name(benchmark::State& s) { instructions(s, source, Engine::Interpreter); }        \
  BENCHMARK(name);                                                                        \
  void name##Compiled(benchmark::State& s) { instructions(s, source, Engine::Compiled); } \
  BENCHMARK(name##Compiled)
BOTH_ENGINES(BitLogic, bitSource());
BOTH_ENGINES(MixedLoop, loopSource(kMixed));
BOTH_ENGINES(Reals, loopSource(kReals));
BOTH_ENGINES(Indirect, loopSource(kIndirect));
BOTH_ENGINES(Timers, loopSource(kTimers));
#undef BOTH_ENGINES

void calls(benchmark::State& state, Callee callee, Engine engine) {
  constexpr int kCalls = 500;
  station::Station station = stationWith(callingSource(kCalls, callee), engine);
  for (auto _ : state) station.runOb1();
  state.SetItemsProcessed(state.iterations() * kCalls);
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
}
void FcCalls(benchmark::State& s) { calls(s, Callee::Function, Engine::Interpreter); }
BENCHMARK(FcCalls);
void FcCallsCompiled(benchmark::State& s) { calls(s, Callee::Function, Engine::Compiled); }
BENCHMARK(FcCallsCompiled);
void FbCalls(benchmark::State& s) { calls(s, Callee::FunctionBlock, Engine::Interpreter); }
BENCHMARK(FbCalls);
void FbCallsCompiled(benchmark::State& s) { calls(s, Callee::FunctionBlock, Engine::Compiled); }
BENCHMARK(FbCallsCompiled);

}  // namespace
}  // namespace merker::bench
