// A program and everything that happens to it, for both engines.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "address/block_id.h"
#include "icode/region.h"

namespace merker::differential {

struct Case {
  std::string model = "314C-2 PtP";
  std::uint32_t seed = 0;  // of registers, memory, interrupts and the instants at which both stop
  std::map<BlockId, std::vector<std::uint8_t>> blocks;
  // Whether the blocks of system_calls.awl are there too.
  bool withSystemCalls() const { return seed % 4 == 0; }
};

// As lines of text: "model …", "seed …", "OB 1 = 68 1D …".
std::string toText(const Case& c);
std::optional<Case> fromText(const std::string& text);
std::string listing(const Case& c);

// Runs the case on both engines, which stop a dozen times to be compared. What is different at the
// first stop where something is; empty if nothing is. `broken`: this emitter gives wrong code;
// `slots`: so many values at most find room besides the registers of the host.
std::string difference(const Case& c, std::optional<icode::Opcode> broken = {},
                       std::uint32_t slots = UINT32_MAX);
// The same difference with as few instructions as possible.
Case shrink(Case c, std::optional<icode::Opcode> broken = {});

// A random program of all kinds of instructions.
Case randomCase(std::uint32_t seed);
// One row of encodings.inc with a random operand and state.
Case rowCase(std::size_t row, std::uint32_t seed);
// One row behind every edge (edges.h) in ACCU 1, with the edge so many places further in ACCU 2, as
// constants or out of flags; nothing for a row with an operand in memory.
std::optional<Case> edgeCase(std::size_t row, std::uint32_t distance, bool known);
// Many looks at timers, of which some end just then.
Case timerCase(std::uint32_t seed);
// Accesses through an address register about the ends of two data blocks that are exchanged.
Case swapCase(std::uint32_t seed);
// A block that calls another one, and itself, until the nesting depth ends.
Case nestingCase();
// Calls in calls of short blocks that change data blocks and AR2, with jumps and ends among them;
// no blocks but those of interrupts if it does not compile.
Case nestedCase(std::uint32_t seed);

}  // namespace merker::differential
