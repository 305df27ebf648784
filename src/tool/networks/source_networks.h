// The networks of a source text as trees, and what an edit of a tree makes of the text. The text
// is the truth; it need not compile.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "address/area.h"
#include "block/block.h"
#include "graph/network.h"
#include "graph/reason.h"
#include "graph/rules.h"
#include "graph/source_network.h"
#include "source/source_file.h"
#include "source/symbol_table.h"

namespace merker::networks {

// What the words of a text may refer to. All of it may be missing.
struct Surroundings {
  source::Language language = source::Language::Step7;
  const source::SymbolTable* symbols = nullptr;
  const block::Program* program = nullptr;  // STEP 7: blocks of other texts, as last compiled
  const block::Program* library = nullptr;  // STEP 7: what the CPU brings
  std::optional<Mnemonics> mnemonics;       // STEP 7; nothing: those that the text shows
};

struct Network {
  std::size_t number = 1;              // in its block
  graph::SourceNetwork source;         // where it is written, its statements and their lines
  std::optional<graph::Network> tree;  // none: it stays AWL
  graph::Refusal refusal;              // then the reason
};

// A block with code: data blocks and types have no networks.
struct Block {
  std::string name, symbol;         // "FB 1"
  std::uint32_t line = 1, end = 1;  // lines [line, end)
  const graph::Rules* rules = nullptr;
  Mnemonics mnemonics = Mnemonics::German;  // of its text
  std::vector<Network> networks;
};

// All blocks of a text, with their lines only: `networks` is empty.
std::vector<Block> blocks(const source::SourceFile& file, const Surroundings& around);
// The block at a line with its networks; nothing if there is none.
std::optional<Block> blockAt(const source::SourceFile& file, std::uint32_t line,
                             const Surroundings& around);

// Lines [from, to) of the text become `lines`; from == to: inserted before that line.
struct TextEdit {
  std::uint32_t from = 1, to = 1;
  std::vector<std::string> lines;
  std::size_t network = 1;  // to select: its number, and the number of a statement in it (-1: none)
  std::int64_t node = -1;
  bool operator==(const TextEdit&) const = default;
};

// Head, title and comment of a network.
struct Heading {
  std::string title;
  std::vector<std::string> comment;
};

// Nothing: the block has no such network.
std::optional<TextEdit> insertNetwork(const source::SourceFile& file, const Block& block,
                                      std::size_t number, bool before, const Heading& heading = {});
std::optional<TextEdit> removeNetwork(const source::SourceFile& file, const Block& block,
                                      std::size_t number);
std::optional<TextEdit> changeHeading(const source::SourceFile& file, const Block& block,
                                      std::size_t number, const Heading& heading);

// What `edit` of a tree makes of the text: graph/edit.h.

}  // namespace merker::networks
