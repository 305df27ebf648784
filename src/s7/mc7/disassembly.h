// Machine code as a listing: one line per instruction, the parameter list behind a call entry by
// entry.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "address/area.h"
#include "address/block_id.h"

namespace merker::mc7 {

enum class LineKind : std::uint8_t { Instruction, Parameter, Illegal };

struct Line {
  std::uint32_t offset = 0;  // bytes from the start of the code
  std::span<const std::uint8_t> bytes;
  LineKind kind = LineKind::Instruction;
  std::string text;
};

// Goes through the code to its end whatever it contains: a word that begins no instruction becomes
// "illegal". The bytes of a line are those of `code`.
std::vector<Line> disassemble(std::span<const std::uint8_t> code, Mnemonics mnemonics);

// "0000: 00100000      U     E 0.0"
std::string toString(const Line& line);

// Number of entries of the parameter list at the start of `code` (a jump over them, `70 0B kk kk`);
// -1 if there is none or it does not fit.
int parameterListLength(std::span<const std::uint8_t> code);

// The blocks that UC and CC name, as often as they do; a number in memory names none.
std::vector<BlockId> calledBlocks(std::span<const std::uint8_t> code);

// Places of the jumps in words, as the segment table of a block holds them; not the jumps over
// parameter lists.
std::vector<std::uint32_t> jumpPositions(std::span<const std::uint8_t> code);

}  // namespace merker::mc7
