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
// OB 1 that calls a block with five parameters, `calls` times.
enum class Callee { Function, FunctionBlock };
std::string callingSource(int calls, Callee callee);
// OB 1 of about so many instructions of ordinary control code, for a 314C.
std::string controlSource(int instructions);
// OB 1 of the 10,000 bit instructions of bit_operations.h, straight on.
std::string bitSource();
// OB 1 with a loop over `body`, 1000 times.
std::string loopSource(const std::string& body);

// Ends the program with the problems if there are any.
std::shared_ptr<const block::Program> compiled(const std::string& source,
                                               const char* model = "generic");

}  // namespace merker::bench
