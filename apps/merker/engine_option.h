// --engine of the commands that run a program.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}
namespace merker::controller {
class Controller;
}

namespace merker::app {

void addEngine(CLI::App& command, std::string& engine);
// --no-skip: every cycle is computed, also one that is proven to be the same as the one before.
void addNoSkip(CLI::App& command, bool& noSkip);
void useSkipping(bool noSkip, controller::Controller& plc);
// Why this computer does not have it, as text.
std::optional<std::string> whyMissing(const std::string& engine);
// Why not, as text. Without a name: compiled as soon as that pays, in real time by another thread.
std::optional<std::string> useEngine(const std::string& engine, controller::Controller& plc,
                                     bool realTime = false);

}  // namespace merker::app
