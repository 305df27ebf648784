// Where the program uses what: the cross reference list of STEP 7, from the machine code of the
// blocks and their lines (S7-EDIT-22).
#pragma once

#include <string>
#include <vector>

#include "block/block.h"
#include "mc7/instruction.h"
#include "monitor/code_map.h"
#include "scenario/term.h"
#include "source/symbol_table.h"

namespace merker::monitor {

enum class Use : std::uint8_t { Read, Write, ReadWrite, Call };
std::string_view name(Use use);  // "R", "W", "RW", "-"

struct CrossReference {
  std::string operand;     // "E 0.0", "DB1.DBW 4", "T 1", "FC 3"
  std::string symbol;      // its symbolic name, if any
  mc7::Operand key;        // area, width, address: the order of the list
  std::int32_t db = -1;    // of data; -1: which block is open there is not known
  std::uint32_t bits = 0;  // of a range (ANY, composite parameter); 0: what the operand's width has
  Use use = Use::Read;
  SourcePlace place;
  std::uint32_t statement = 0;  // instruction of its network, from 1
  std::string instruction;      // "U     E 0.0", "CALL  FB 1, DB 10"
};

struct CrossReferenceOptions {
  Mnemonics mnemonics = Mnemonics::German;
  // Interfaces of what the CPU brings: whether a parameter of an SFC is read or written.
  const block::Program* library = nullptr;
};

// Sorted as STEP 7 sorts: E, A, M, P, T, Z, DB contents, blocks; then address, then place.
std::vector<CrossReference> crossReferences(const block::Program& program,
                                            const source::SymbolTable& symbols,
                                            const CrossReferenceOptions& options = {});

// Only operands that touch one of those in `filter`: "M 10.0", "MW 10" (overlap counts), "E", "DB
// 1", "T", "FC 3", "\"Motor\"", separated by commas. P0904 if a part is no operand.
Result<std::vector<CrossReference>> filtered(const std::vector<CrossReference>& list,
                                             std::string_view filter,
                                             const simulator::Resolver& resolver);

// Symbols of E, A, M, P, T, Z and blocks that no instruction uses.
std::vector<source::Symbol> unusedSymbols(const std::vector<CrossReference>& list,
                                          const source::SymbolTable& symbols);
// Operands that are used and have no symbol, each once.
std::vector<std::string> operandsWithoutSymbol(const std::vector<CrossReference>& list);

}  // namespace merker::monitor
