// The networks of a block as pictures for browsers.
#pragma once

#include "graph/language.h"
#include "networks/operand_names.h"
#include "networks/source_networks.h"
#include "workbench/json.h"

namespace merker::workbench {

enum class NetworkView : std::uint8_t { Kop, Fup };
using OperandDisplay = networks::OperandForm;

struct NetworkDisplay {
  NetworkView view = NetworkView::Kop;
  graph::Language language = graph::Language::German;
  OperandDisplay operands = OperandDisplay::Written;
  const source::SymbolTable* symbols = nullptr;
  Mnemonics mnemonics = Mnemonics::German;
  const block::Block* compiled = nullptr;  // the block as it was compiled last, for its types
};

// Of all networks of the block.
Json networkRows(const networks::Block& block, const NetworkDisplay& display);

}  // namespace merker::workbench
