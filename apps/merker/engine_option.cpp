#include "engine_option.h"

#include <CLI/CLI.hpp>

#include "station/engines.h"
#include "station/station.h"

namespace merker::app {

void addEngine(CLI::App& command, std::string& engine) {
  command
      .add_option("--engine", engine,
                  "interpreter, or jit: machine code of this computer, same results")
      ->check(CLI::IsMember({"interpreter", "jit"}));
}

std::optional<std::string> whyMissing(const std::string& engine) {
  if (engine != "jit" || station::Engines::canCompile()) return std::nullopt;
  return "--engine: there is no jit for this processor; use interpreter";
}

std::optional<std::string> useEngine(const std::string& engine, station::Station& station) {
  if (auto problem = whyMissing(engine)) return problem;
  station.setEngine(engine == "jit" ? station::Engine::Compiled : station::Engine::Interpreter);
  return std::nullopt;
}

}  // namespace merker::app
