// Four stations, each with a rotary axis whose encoder runs near 60 kHz; SFB 44 is called in each
// cycle. How much faster than real time they are, all four on one thread.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <vector>

#include "project/project.h"
#include "station/station.h"
#include "step7/compiler.h"
#include "system/library.h"

namespace merker::bench {
namespace {

void FourAxes(benchmark::State& state) {
  constexpr std::size_t kAxes = 4;
  constexpr Duration kStep = Duration::milliseconds(100);
  const project::Project project = project::load(MERKER_SOURCE_DIR "/bench/axis", "");
  const block::Program library = system::library(*project.model);
  step7::CompileOptions options;
  options.model = project.model;
  options.library = &library;
  options.symbols = &project.symbols;
  const auto program =
      std::make_shared<const block::Program>(step7::compile(project.sources, options).program);
  std::vector<station::Station> stations;
  for (std::size_t i = 0; i < kAxes; ++i) {
    station::Options o;
    o.model = project.model;
    o.parameters = project.parameters;
    o.hardware = project.hardware;
    o.plants = project.plants;
    o.program = program;
    station::Station& station = stations.emplace_back(std::move(o));
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
