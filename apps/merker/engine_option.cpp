#include "engine_option.h"

#include <CLI/CLI.hpp>

#include "control/cnc.h"
#include "station/mixed_engine.h"
#include "station/station.h"

namespace merker::app {

void addEngine(CLI::App& command, std::string& engine) {
  command
      .add_option("--engine", engine,
                  "interpreter, or jit: machine code of this computer, same results")
      ->check(CLI::IsMember({"interpreter", "jit"}));
}

std::optional<std::string> whyMissing(const std::string& engine) {
  if (engine != "jit" || station::MixedEngine::canCompile()) return std::nullopt;
  return "--engine: jit is not available for this processor; use interpreter";
}

std::optional<std::string> useEngine(const std::string& engine, controller::Controller& plc) {
  if (auto problem = whyMissing(engine)) return problem;
  const bool jit = engine == "jit";
  if (auto* control = dynamic_cast<cnc::Cnc*>(&plc))
    control->setCompiled(jit);
  else if (auto* station = dynamic_cast<station::Station*>(&plc))
    station->setEngine(jit ? station::Engine::Compiled : station::Engine::Interpreter);
  return std::nullopt;
}

}  // namespace merker::app
