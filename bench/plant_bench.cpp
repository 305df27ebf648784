// A whole plant: the sorting plant of the course runs its scenario, inputs, waiting and
// expectations included.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>

#include "compilation/build.h"
#include "scenario/runner.h"
#include "together.h"

namespace merker::bench {
namespace {

constexpr const char* kFolder = MERKER_SOURCE_DIR "/examples/sorting-plant";

struct Plant {
  compilation::Build build = compilation::build(project::load(kFolder, ""), false);

  station::Station station(station::Engine engine) const {
    station::Station result = build.station();
    (void)result.setEngine(engine);
    return result;
  }
  // Its texts are views into the file.
  simulator::Scenario scenario(const source::SourceFile& file) const {
    Problems problems;
    auto list = simulator::parseScenarios(file, problems);
    const project::Project& project = build.project;
    simulator::resolve(list.front(), build.operands(), problems,
                       project.hardware ? &*project.hardware : nullptr, &project.plants);
    for (const Problem& problem : problems.list()) std::cerr << problem.message << '\n';
    return list.front();
  }
};

void plant(benchmark::State& state, station::Engine engine) {
  const Plant plant;
  const auto file = source::readSource(std::string(kFolder) + "/several.scn");
  if (!file) return state.SkipWithError("several.scn is missing");
  const simulator::Scenario scenario = plant.scenario(file.value());
  station::Station station = plant.station(engine);
  std::int64_t passed = 0;
  for (auto _ : state) {
    const Instant begin = station.now();
    if (!simulator::runScenario(scenario, station).passed())
      state.SkipWithError("the scenario failed");
    passed += (station.now() - begin).ns;
  }
  state.SetItemsProcessed(passed);
}
// By itself, a box every ten seconds, as `merker run examples/sorting-plant --for 10m`.
void alone(benchmark::State& state, station::Engine engine) {
  constexpr Duration kTime = Duration::seconds(600);
  const Plant plant;
  station::Station station = plant.station(engine);
  if (!station.warmRestart()) std::abort();
  for (auto _ : state) station.advanceTo(station.now() + kTime);
  state.SetItemsProcessed(state.iterations() * kTime.ns);
}

// A thousand of them in one process, ten virtual seconds together.
void ThousandPlants(benchmark::State& state) {
  constexpr std::size_t kPlants = 1000;
  constexpr Duration kTime = Duration::seconds(10);
  const Plant plant;
  Together stations(kPlants, [&] {
    station::Station station = plant.station(station::Engine::Compiled);
    if (!station.warmRestart()) std::abort();
    return station;
  });
  for (auto _ : state) stations.advance(kTime);
  state.SetItemsProcessed(state.iterations() * kTime.ns);
}
BENCHMARK(ThousandPlants)->UseRealTime()->Iterations(3);

void TenMinutes(benchmark::State& s) { alone(s, station::Engine::Interpreter); }
BENCHMARK(TenMinutes);
void TenMinutesCompiled(benchmark::State& s) { alone(s, station::Engine::Compiled); }
BENCHMARK(TenMinutesCompiled);

void SortingPlant(benchmark::State& s) { plant(s, station::Engine::Interpreter); }
BENCHMARK(SortingPlant);
void SortingPlantCompiled(benchmark::State& s) { plant(s, station::Engine::Compiled); }
BENCHMARK(SortingPlantCompiled);

}  // namespace
}  // namespace merker::bench
