// Another form of an operand: its symbol in place of its address, or the reverse.
#pragma once

#include <string>
#include <string_view>

#include "graph/statement.h"
#include "source/symbol_table.h"

namespace merker::networks {

// How operands are shown: as the text has them, by their symbols, by their addresses.
enum class OperandForm : std::uint8_t { Written, Symbolic, Absolute };

struct OperandNames {
  OperandForm form = OperandForm::Written;
  const source::SymbolTable* symbols = nullptr;
  Mnemonics mnemonics = Mnemonics::German;  // of addresses

  // "Motor" in quotation marks, of STEP 5 -MOTOR; "A 1.0". Empty: it has no other form.
  std::string of(std::string_view operand) const;
};

void rename(graph::Statements& statements, const OperandNames& names);

}  // namespace merker::networks
