// Where the program uses what: the cross reference list of a programming device, from the machine
// code of the blocks and their lines (S7-EDIT-22). The rows are the same for both families.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "address/reference.h"
#include "monitor/code_map.h"
#include "monitor/filter_words.h"
#include "scenario/term.h"
#include "source/symbol_table.h"

namespace merker::monitor {

enum class Use : std::uint8_t { Read, Write, ReadWrite, Call };
std::string_view name(Use use);  // "R", "W", "RW", "-"

struct CrossReference {
  std::string operand;           // "E 0.0", "DB1.DBW 4", "T 1", "FC 3", "=EIN"
  std::string symbol;            // its symbolic name, if any
  address::Operand key;          // kind None: a block or a formal operand
  std::optional<BlockId> block;  // that is called or opened; that a formal operand belongs to
  std::int32_t instance = -1;    // data block of the CALL that names `block`, if it has one
  std::uint32_t formal = 0;      // word of the parameter list, from 1; 0: not a formal operand
  std::int32_t db = -1;          // of data; -1: which block is open there is not known
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

// Sorted as STEP 7 sorts: E, A, M, P, T, Z, DB contents, blocks, formal operands of STEP 5; then
// address, then place.
std::vector<CrossReference> crossReferences(const ProgramCode& program,
                                            const source::SymbolTable& symbols,
                                            const CrossReferenceOptions& options = {});

// Only operands that touch one of those in `filter`: "M 10.0", "MW 10" (overlap counts), "E", "DB
// 1", "T", "FC 3", "\"Motor\"", of STEP 5 "-MOTOR", "=EIN", separated by commas. P0904 if a part is
// no operand.
Result<std::vector<CrossReference>> filtered(const std::vector<CrossReference>& list,
                                             std::string_view filter,
                                             const simulator::Resolver& resolver,
                                             const FilterWords& words = step7Words(),
                                             const source::SymbolTable& symbols = {});

// Symbols of E, A, M, P, T, Z and blocks that no instruction uses.
std::vector<source::Symbol> unusedSymbols(const std::vector<CrossReference>& list,
                                          const source::SymbolTable& symbols);
// Operands that are used and have no symbol, each once.
std::vector<std::string> operandsWithoutSymbol(const std::vector<CrossReference>& list);

}  // namespace merker::monitor
