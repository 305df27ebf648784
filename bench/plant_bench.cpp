// A whole plant: the sorting plant of the course runs its scenario, inputs, waiting and
// expectations included.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>

#include "project/project.h"
#include "scenario/runner.h"
#include "station/station.h"
#include "step7/compiler.h"
#include "system/library.h"

namespace merker::bench {
namespace {

constexpr const char* kFolder = MERKER_SOURCE_DIR "/examples/sorting-plant";

struct Plant {
  project::Project project = project::load(kFolder, "");
  block::Program library = system::library(*project.model);
  step7::CompileOptions options{
      .model = project.model, .library = &library, .symbols = &project.symbols};
  std::shared_ptr<const block::Program> program =
      std::make_shared<const block::Program>(step7::compile(project.sources, options).program);

  station::Station station(station::Engine engine) const {
    station::Options o;
    o.model = project.model;
    o.parameters = project.parameters;
    o.hardware = project.hardware;
    o.plants = project.plants;
    o.program = program;
    o.engine = engine;
    return station::Station(std::move(o));
  }
  // Its texts are views into the file.
  simulator::Scenario scenario(const source::SourceFile& file) const {
    Problems problems;
    auto list = simulator::parseScenarios(file, problems);
    const auto resolver = [this](std::string_view text, const Position& at) {
      return step7::resolve(text, *program, options, at);
    };
    simulator::resolve(list.front(), resolver, problems,
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
void SortingPlant(benchmark::State& s) { plant(s, station::Engine::Interpreter); }
BENCHMARK(SortingPlant);
void SortingPlantCompiled(benchmark::State& s) { plant(s, station::Engine::Compiled); }
BENCHMARK(SortingPlantCompiled);

}  // namespace
}  // namespace merker::bench
