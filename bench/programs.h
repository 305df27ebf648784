// AWL sources for measurements, always the same.
#pragma once

#include <memory>
#include <string>

#include "block/block.h"

namespace merker::bench {

// Functions, an FB with instance, a DB and OB 1: `lines` lines of ordinary control code with
// comments.
std::string largeSource(int lines);
// OB 1 with some thousand instructions as control programs mix them: bits, words, integers,
// compares, jumps, REAL.
std::string mixedSource();
// OB 1 that calls FC 1 with two inputs and an output, `calls` times.
std::string callingSource(int calls);
// OB 1 of the 10,000 bit instructions of bit_operations.h, straight on.
std::string bitSource();
// OB 1 with a loop over `body`, 1000 times.
std::string loopSource(const std::string& body);

// Compiles for the generic CPU; ends the program with the problems if there are any.
std::shared_ptr<const block::Program> compiled(const std::string& source);

}  // namespace merker::bench
