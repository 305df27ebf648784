// The body of an OB, PB, SB or FB: lines to machine code.
#pragma once

#include <map>
#include <set>
#include <string>

#include "mc5/block.h"
#include "source/symbol_table.h"
#include "step5/block_source.h"
#include "step5/declaration.h"

namespace merker::step5 {

// What calls find in the program and among the resident macros.
struct Callable {
  // Declarations of the FBs by number; null: the declaration has errors, told where it stands.
  std::map<std::uint16_t, const mc5::Block*> functionBlocks;
  std::map<std::uint16_t, std::string> names;  // what NAME says in an FB, beside its head
  std::set<mc5::BlockId> blocks;
  const source::SymbolTable* symbols = nullptr;
};

// `block` has its head and declaration; words, lines, networks, labels and checks come here.
void compileCode(const BlockSource& source, std::size_t firstLine, const Callable& known,
                 bool checks, mc5::Block& block, Problems& problems);

}  // namespace merker::step5
