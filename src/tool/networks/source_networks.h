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
  std::uint32_t line = 1, end = 1;  // lines [line, end), each of one block only
  const graph::Rules* rules = nullptr;
  Mnemonics mnemonics = Mnemonics::German;  // of its text
  std::vector<Network> networks;
};

// All blocks of a text, with their lines only: `networks` is empty.
std::vector<Block> blocks(const source::SourceFile& file, const Surroundings& around);
// The block at a line with its networks; nothing if there is none.
std::optional<Block> blockAt(const source::SourceFile& file, std::uint32_t line,
                             const Surroundings& around);

// The parameters of the block that a CALL names ("FB 1, DB 1", "#instance", "Motor"), as the block
// at the line sees it; none if nobody knows it.
std::vector<graph::Argument> parametersOf(std::string_view called, const source::SourceFile& file,
                                          std::uint32_t line, const Surroundings& around);

}  // namespace merker::networks
