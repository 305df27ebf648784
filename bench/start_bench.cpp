#include <benchmark/benchmark.h>

#include <cstdlib>

namespace {

// The whole program: start, read, compile, one cycle, print, end.
void StartOfASmallProgram(benchmark::State& state) {
  const char* const command = "'" MERKER_PROGRAM "' run '" MERKER_SOURCE_DIR
                              "/bench/small.awl' --cycles 1 --print 'A 4.0' >/dev/null";
  for (auto _ : state)
    if (std::system(command) != 0) state.SkipWithError("merker run failed");
}
BENCHMARK(StartOfASmallProgram)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
