// Machine code as a listing: one line per instruction.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace merker::mc5 {

struct Line {
  std::uint32_t offset = 0;  // words from the start of the code
  std::span<const std::uint16_t> words;
  bool illegal = false;
  std::string text;
};

// Goes through the code to its end whatever it contains: a word that begins no instruction becomes
// "illegal". Parameters behind a call of a function block are no instructions; they show as KH.
std::vector<Line> disassemble(std::span<const std::uint16_t> code);

// "0004: 7046 CACD       P     D 205.10"; the offset counts words. A line without words has none.
std::string toString(const Line& line);

}  // namespace merker::mc5
