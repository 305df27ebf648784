#include <benchmark/benchmark.h>

#include "programs.h"
#include "station/station.h"

namespace merker::bench {
namespace {

// 100,000 lines of AWL into blocks.
void Compile100000Lines(benchmark::State& state) {
  const std::string source = largeSource(100'000);
  for (auto _ : state) benchmark::DoNotOptimize(compiled(source));
}
BENCHMARK(Compile100000Lines)->Unit(benchmark::kMillisecond);

// 100,000 lines, compiled to blocks before, into machine code of the host.
void Translate100000Lines(benchmark::State& state) {
  station::Options options;
  options.model = findCpuModel("generic");
  options.program = compiled(largeSource(100'000));
  station::Station station(std::move(options));
  for (auto _ : state) {
    station.setEngine(station::Engine::Compiled);
    station.setEngine(station::Engine::Interpreter);
  }
}
BENCHMARK(Translate100000Lines)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace merker::bench
