// A STEP 5 program and everything that happens to it, for both engines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "icode/region.h"
#include "mc5/block.h"
#include "mc5/instruction.h"

namespace merker::differential5 {

struct Case {
  std::uint32_t seed = 0;  // of machine data, memory, terminals and the instants of comparison
  mc5::Program program;
  bool watched = false;  // a probe looks at one block after the other
};

// A random program of all kinds of instructions.
Case randomCase(std::uint32_t seed);
// One row of encodings.inc with random operands, between loads and a look at what it left: loads of
// random numbers, or of edges (edges.h) from this one on.
Case rowCase(std::size_t row, std::uint32_t seed, std::optional<std::size_t> edge = {});
// TIR writes another instruction into the code behind it.
Case writingCase(std::uint32_t seed);
// Calls, block ends, A DB and formal operands, which all run compiled.
Case callingCase(std::uint32_t seed);
std::string listing(const Case& c);

struct Outcome {
  std::string difference;  // at the first stop where something differs; empty if nothing does
  std::uint64_t instructions = 0, compiled = 0;
  std::uint64_t cycles = 0, passed = 0;  // of runQuiet
};
// Runs the case on two PLCs, one for each engine, which stop a dozen times to be compared.
// `broken`: this emitter gives wrong code.
Outcome run(const Case& c, std::optional<icode::Opcode> broken = {});

// Runs the case for some seconds on two PLCs, of which one passes over quiet cycles.
Outcome runQuiet(const Case& c, bool compiled);

}  // namespace merker::differential5
