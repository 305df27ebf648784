// From machine code back to the source: statements, lines, networks of a block.
#pragma once

#include <cstdint>
#include <string>

#include "cpu/diagnostics.h"
#include "monitor/code.h"

namespace merker::monitor {

// One statement of the source: all instructions the compiler made of it (a CALL makes several).
// Offsets count bytes or words, as the code of the block does.
struct Statement {
  std::uint32_t begin = 0, end = 0;
  std::uint32_t line = 0, column = 0;
  bool operator==(const Statement&) const = default;
};

// The statement that the instruction at `offset` belongs to. Without lines, and for what a block
// does before its first statement: line 0.
Statement statementAt(const BlockCode& block, std::uint32_t offset);
// Whether a statement begins at this instruction; in a block without lines every instruction does.
bool beginsStatement(const BlockCode& block, std::uint32_t offset);
// Whether the instruction is the BE that the compiler adds behind the last statement.
bool endsBlock(const BlockCode& block, std::uint32_t offset);
// 1, 2 …; 0 if the block has no networks.
std::uint32_t networkAt(const BlockCode& block, std::uint32_t offset);
// 1, 2 … in its network; 0 without lines.
std::uint32_t statementNumber(const BlockCode& block, std::uint32_t offset);

// A place in the program as a person reads it.
struct SourcePlace {
  BlockId block{};
  std::uint32_t offset = 0;
  std::string file;
  std::uint32_t line = 0, network = 0;
  CodeUnit unit = CodeUnit::Byte;  // of the offset
  bool operator==(const SourcePlace&) const = default;
};
SourcePlace sourcePlace(const BlockCode& block, std::uint32_t offset);
// A block that is not in the program keeps its number and offset.
SourcePlace sourcePlace(const ProgramCode& program, BlockId id, std::uint32_t offset);
// "FC 1 byte 6 (plant.awl:12)", "PB 5 word 6 (press.s5:12)"
std::string toString(const SourcePlace& place);

}  // namespace merker::monitor
