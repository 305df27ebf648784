// The type of an operand as it is declared: a variable of the block, a symbol.
#pragma once

#include <optional>
#include <string_view>

#include "block/block.h"
#include "source/symbol_table.h"

namespace merker::workbench {

class DeclaredTypes {
 public:
  // Either may be missing; both must outlive it.
  DeclaredTypes(const source::SymbolTable* symbols, const block::Block* block)
      : symbols_(symbols), block_(block) {}

  // Of "#list[2].speed", "\"Motor\"", "MW 10"; nothing: nobody has declared it, or it has parts.
  std::optional<TypeCode> of(std::string_view operand) const;

 private:
  const block::Type* local(std::string_view path) const;
  const source::Symbol* symbol(std::string_view operand) const;

  const source::SymbolTable* symbols_;
  const block::Block* block_;
};

}  // namespace merker::workbench
