// A STEP 5 block as the programmer hands it to the PLC: header data, declaration, machine code or
// data words. Source text is a view of it.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "check/check.h"
#include "mc5/operand.h"

namespace merker::mc5 {

// Art and Typ of a formal operand (S5-FB-09 … -12).
enum class ParameterKind : std::uint8_t { Input, Output, Data, Block, Timer, Counter };

struct Parameter {
  std::string name;  // up to four characters (S5-FB-08)
  ParameterKind kind = ParameterKind::Input;
  Width width = Width::Bit;     // Input, Output: Bit, Byte, Word, Double
  Format format = Format::Hex;  // Data
};

// A comment of the source: behind what stands at the word, or on a line of its own before it. With
// its mark.
struct Comment {
  std::uint32_t offset = 0;  // words
  bool behind = false;
  std::string text;
};

struct BlockId {
  BlockType type = BlockType::Ob;
  std::uint16_t number = 0;
  auto operator<=>(const BlockId&) const = default;
};

// Where an instruction or data word comes from; entries ascend by offset and hold until the next.
struct LineEntry {
  std::uint32_t offset = 0;  // words
  std::uint32_t line = 0, column = 0;
};

struct Network {
  std::uint32_t offset = 0;  // words
  std::string title;
};

struct Block {
  BlockId id;
  std::string name;           // FB: up to eight characters
  std::uint32_t library = 0;  // BIB
  std::vector<Parameter> parameters;
  // Code with its BE, without the five words of the header; a DB's data words.
  std::vector<std::uint16_t> words;
  std::vector<Format> formats;  // DB: how each word is shown
  std::vector<Network> networks;
  std::map<std::uint32_t, std::string> labels;   // by offset
  std::map<std::uint32_t, std::uint32_t> texts;  // DB: where a text (KS) begins, and its words
  std::vector<std::string> heading;              // comment lines of the file above its first block
  std::vector<Comment> comments;                 // in the order of the source
  std::string file;
  std::vector<LineEntry> lines;
  // Offsets count words; the code of operands is MC5, the high byte of a word first.
  std::vector<block::Check> checks;
};

constexpr std::uint32_t kHeaderWords = 5;  // S5-BLK-08

// The blocks of one PLC. Same type and number only once.
using Program = std::map<BlockId, Block>;

}  // namespace merker::mc5
