#include "engine_option.h"

#include <CLI/CLI.hpp>

#include "station/station.h"

namespace merker::app {

void addEngine(CLI::App& command, std::string& engine) {
  command
      .add_option("--engine", engine,
                  "interpreter, or jit: machine code of this computer, same results")
      ->check(CLI::IsMember({"interpreter", "jit"}));
}

std::optional<std::string> useEngine(const std::string& engine, station::Station& station) {
  const bool jit = engine == "jit";
  if (station.setEngine(jit ? station::Engine::Compiled : station::Engine::Interpreter))
    return std::nullopt;
  return "--engine: there is no jit for this processor; use interpreter";
}

}  // namespace merker::app
