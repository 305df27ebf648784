// STEP 7 AWL to MC7 blocks: the whole front end behind three functions.
#pragma once

#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "address/reference.h"
#include "block/block.h"
#include "catalogue/cpu_model.h"
#include "mc7/instruction.h"
#include "source/source_file.h"
#include "source/symbol_table.h"

namespace merker::step7 {

struct CompileOptions {
  const CpuModel* model = &defaultCpuModel();
  // SFC, SFB and library functions that the CPU brings: interface only, no code.
  const block::Program* library = nullptr;
  const source::SymbolTable* symbols = nullptr;
  // Translate //= comments into checks.
  bool checks = false;
  std::stop_token stop;  // ends the compilation; what there is then is of no use
  // Of all sources; without it each source shows its own (S7-SRC-10).
  std::optional<Mnemonics> mnemonics = std::nullopt;
};

struct Compilation {
  block::Program program;
  Problems problems;
  bool ok() const { return !problems.hasErrors(); }
};

// Compiles all sources into one program. Blocks may stand in any order and in any file. All
// problems are collected; a block with an error is left out of the program.
Compilation compile(const std::vector<source::SourceFile>& sources, const CompileOptions& options);

// "MW 10", "DB1.DBW 4", "\"Motor\"", "DB1.var[2]", "T 1": an operand for monitor, scenario,
// --print. Both mnemonics.
Result<address::Reference> resolve(std::string_view text, const block::Program& program,
                                   const CompileOptions& options, const Position& at);

// One instruction as `merker assemble --mc7` takes it; jumps with their distance in words. Without
// a setting both mnemonics, and a word that exists in both is German (SE). `at` is where the text
// begins.
Result<mc7::Instruction> parseInstruction(std::string_view text, const Position& at,
                                          std::optional<Mnemonics> setting = std::nullopt);

// An entry of a parameter list, a line of its own for `merker assemble --mc7`: P#V 20.0, 5. Nothing
// if the text is not one.
std::optional<Result<std::uint32_t>> parseListEntry(std::string_view text, const Position& at);

}  // namespace merker::step7
