#include "engine_option.h"

#include <CLI/CLI.hpp>

#include "jit/native.h"
#include "plc/machine_code.h"
#include "plc/quiet_cycles.h"

namespace merker::app {

void addEngine(CLI::App& command, std::string& engine) {
  command
      .add_option("--engine", engine,
                  "interpreter, or jit: machine code of this computer; same results. Without it: "
                  "jit for code that runs often enough")
      ->check(CLI::IsMember({"interpreter", "jit"}));
}

void addNoSkip(CLI::App& command, bool& noSkip) {
  command.add_flag(
      "--no-skip", noSkip,
      "compute each cycle, also one that comes to the same as the one before; same results");
}

void useSkipping(bool noSkip, controller::Controller& plc) {
  if (auto* const quiet = controller::capability<controller::QuietCycles>(plc))
    quiet->passOverQuietCycles(!noSkip);
}

std::optional<std::string> whyMissing(const std::string& engine) {
  if (engine != "jit" || jit::available()) return std::nullopt;
  return "--engine: jit is not available for this processor; use interpreter";
}

std::optional<std::string> useEngine(const std::string& engine, controller::Controller& plc,
                                     bool realTime) {
  if (auto problem = whyMissing(engine)) return problem;
  auto* const code = controller::capability<controller::MachineCode>(plc);
  if (engine.empty()) {
    if (code != nullptr) code->compileWhenItPays(realTime);
    return std::nullopt;
  }
  if (code != nullptr ? code->setCompiled(engine == "jit") : engine != "jit") return std::nullopt;
  return "--engine: jit is not available for " + plc.modelName() + "; use interpreter";
}

}  // namespace merker::app
