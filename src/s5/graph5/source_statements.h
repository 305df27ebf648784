// The networks of a block as its listing has them: statements for `graph`, and their places.
#pragma once

#include <optional>
#include <vector>

#include "graph/source_network.h"
#include "source/symbol_table.h"
#include "step5/block_source.h"

namespace merker::graph5 {

// A block has at least one network. The BE at its end is no statement.
std::vector<graph::SourceNetwork> sourceNetworks(const step5::BlockSource& source,
                                                 const source::SymbolTable* symbols);

// An operand that is no part of a listing, as a user types it: "e0.0" is "E 0.0", a symbol gets its
// hyphen. Nothing if more than an operand stands there.
std::optional<graph::Operand> sourceOperand(std::string_view text,
                                            const source::SymbolTable* symbols);

// A block as operations that call it name it.
std::optional<graph::Operand> sourceBlock(std::string_view text,
                                          const source::SymbolTable* symbols);

}  // namespace merker::graph5
