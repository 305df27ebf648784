// --cpu NAME of every command that compiles.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace merker::app {

// An unknown name is wrong usage.
void addCpu(CLI::App& command, std::string& cpu);

}  // namespace merker::app
