#include "started.h"

#include <cstdlib>

#include "programs.h"

namespace merker::bench {

station::Station stationWith(const std::string& source, station::Engine engine) {
  station::Options options;
  options.model = findCpuModel("generic");
  options.program = compiled(source);
  options.engine = engine;
  station::Station station(std::move(options));
  if (!station.warmRestart()) std::abort();
  station.advanceCycles(1);  // through STARTUP
  return station;
}

std::uint64_t instructionsOfLoop(const std::string& body) {
  station::Station station = stationWith(loopSource(body));
  const std::uint64_t before = station.instructions();
  station.runOb1();
  return station.instructions() - before;
}

}  // namespace merker::bench
