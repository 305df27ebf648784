// What the PLC calls a terminal: DI3 of the module at byte 0 is E 0.3, AI1 of that at 256 PEW 258.
#pragma once

#include <string>

#include "io/rack.h"
#include "source/symbol_table.h"

namespace merker::workbench {

// Empty texts: it has no address, or no symbol.
struct TerminalOperand {
  std::string operand, symbol;
};

TerminalOperand terminalOperand(const io::Configuration& configuration, io::Terminal terminal,
                                const source::SymbolTable& symbols);

}  // namespace merker::workbench
