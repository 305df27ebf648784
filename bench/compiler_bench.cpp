#include <benchmark/benchmark.h>

#include "programs.h"

namespace merker::bench {
namespace {

// 100,000 lines of AWL into blocks.
void Compile100000Lines(benchmark::State& state) {
  const std::string source = largeSource(100'000);
  for (auto _ : state) benchmark::DoNotOptimize(compiled(source));
}
BENCHMARK(Compile100000Lines)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace merker::bench
