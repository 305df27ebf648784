#include <benchmark/benchmark.h>

#include "loops.h"
#include "programs.h"
#include "started.h"

namespace merker::bench {
namespace {

using station::Engine;

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
BENCHMARK(Instructions)->Apply(severalTimes);
void InstructionsCompiled(benchmark::State& s) { instructions(s, mixedSource(), Engine::Compiled); }
BENCHMARK(InstructionsCompiled)->Apply(severalTimes);

#define BOTH_ENGINES(name, source)                                                        \
  void name(benchmark::State& s) { instructions(s, source, Engine::Interpreter); }        \
  BENCHMARK(name)->Apply(severalTimes);                                                   \
  void name##Compiled(benchmark::State& s) { instructions(s, source, Engine::Compiled); } \
  BENCHMARK(name##Compiled)->Apply(severalTimes)
BOTH_ENGINES(BitLogic, bitSource());
BOTH_ENGINES(MixedLoop, loopSource(kMixed));
BOTH_ENGINES(Reals, loopSource(kReals));
BOTH_ENGINES(Indirect, loopSource(kIndirect));
BOTH_ENGINES(Timers, loopSource(kTimers));
#undef BOTH_ENGINES

void calls(benchmark::State& state, Callee callee, Engine engine) {
  station::Station station = stationWith(callingSource(kCalls, callee), engine);
  for (auto _ : state) station.runOb1();
  state.SetItemsProcessed(state.iterations() * kCalls);
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
}
void FcCalls(benchmark::State& s) { calls(s, Callee::Function, Engine::Interpreter); }
BENCHMARK(FcCalls)->Apply(severalTimes);
void FcCallsCompiled(benchmark::State& s) { calls(s, Callee::Function, Engine::Compiled); }
BENCHMARK(FcCallsCompiled)->Apply(severalTimes);
void FbCalls(benchmark::State& s) { calls(s, Callee::FunctionBlock, Engine::Interpreter); }
BENCHMARK(FbCalls)->Apply(severalTimes);
void FbCallsCompiled(benchmark::State& s) { calls(s, Callee::FunctionBlock, Engine::Compiled); }
BENCHMARK(FbCallsCompiled)->Apply(severalTimes);

}  // namespace
}  // namespace merker::bench
