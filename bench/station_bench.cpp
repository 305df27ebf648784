#include <benchmark/benchmark.h>

#include <cstdlib>

#include "programs.h"
#include "station/station.h"

namespace merker::bench {
namespace {

station::Station stationWith(const std::string& source) {
  station::Options options;
  options.model = findCpuModel("generic");
  options.program = compiled(source);
  station::Station station(std::move(options));
  if (!station.warmRestart()) std::abort();
  station.advanceCycles(1);  // through STARTUP
  return station;
}

void Instructions(benchmark::State& state) {
  station::Station station = stationWith(mixedSource());
  const std::uint64_t before = station.instructions();
  for (auto _ : state) station.runOb1();
  state.SetItemsProcessed(static_cast<std::int64_t>(station.instructions() - before));
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
}
BENCHMARK(Instructions);

void FcCalls(benchmark::State& state) {
  constexpr int kCalls = 1000;
  station::Station station = stationWith(callingSource(kCalls));
  for (auto _ : state) station.runOb1();
  state.SetItemsProcessed(state.iterations() * kCalls);
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
}
BENCHMARK(FcCalls);

// A cycle with everything the operating system does between two runs of OB 1.
void Cycles(benchmark::State& state) {
  station::Station station = stationWith(callingSource(1));
  for (auto _ : state) station.advanceCycles(1);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(Cycles);

}  // namespace
}  // namespace merker::bench
