// Four stations, each with a rotary axis whose encoder runs near 60 kHz; SFB 44 is called in each
// cycle. How much faster than real time they are, all four on one thread.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <vector>

#include "compilation/build.h"

namespace merker::bench {
namespace {

void FourAxes(benchmark::State& state) {
  constexpr std::size_t kAxes = 4;
  constexpr Duration kStep = Duration::milliseconds(100);
  const compilation::Build build =
      compilation::build(project::load(MERKER_SOURCE_DIR "/bench/axis", ""), false);
  std::vector<station::Station> stations;
  for (std::size_t i = 0; i < kAxes; ++i) {
    station::Station& station = stations.emplace_back(build.station());
    if (!station.warmRestart()) std::abort();
    station.advanceTo(Instant{} + Duration::seconds(5));  // the ramp is over
  }
  for (auto _ : state)
    for (station::Station& station : stations) station.advanceTo(station.now() + kStep);
  state.SetItemsProcessed(state.iterations() * kStep.ns);
  for (const station::Station& station : stations)
    if (station.axis()->outputs().setPoint < 239'000'000)
      state.SkipWithError("an axis does not turn");
}
BENCHMARK(FourAxes);

}  // namespace
}  // namespace merker::bench
