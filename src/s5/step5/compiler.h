// STEP 5 listings to MC5 blocks: the whole front end behind three functions.
#pragma once

#include <stop_token>
#include <string_view>
#include <vector>

#include "base/problem.h"
#include "base/result.h"
#include "mc5/block.h"
#include "mc5/disassembly.h"
#include "mc5/instruction.h"
#include "source/source_file.h"
#include "source/symbol_table.h"

namespace merker::step5 {

struct Compilation {
  mc5::Program program;
  Problems problems;
  bool ok() const { return !problems.hasErrors(); }
};

// Compiles all listings into one program. Blocks may stand in any order and in any file. All
// problems are collected; a block with an error is left out of the program. `checks`: translate
// //= comments. `stop` ends the compilation; what there is then is of no use. `symbols`: the
// assignment list that operands like -START are looked up in.
Compilation compile(const std::vector<source::SourceFile>& sources, bool checks,
                    std::stop_token stop = {}, const source::SymbolTable* symbols = nullptr);

// One instruction as `merker assemble --mc5` takes it: jumps with their distance ("SPA =+4"),
// formal operands with their index ("U =1"). `at` is where the text begins.
Result<mc5::Instruction> parseInstruction(std::string_view text, const Position& at);

// A code block of the program with its machine code: parameters behind a call as NAME : TEST and
// ZAHL : KF +25, in one line with the call the jump over them, which is not shown (4.3.2).
std::vector<mc5::Line> disassemble(const mc5::Program& program, const mc5::Block& block);

// The program as a listing that compiles to the same words; with `symbols` as -START where an
// operand has one.
std::string listing(const mc5::Program& program, const source::SymbolTable* symbols = nullptr);
// One block of it.
std::string listing(const mc5::Program& program, const mc5::Block& block,
                    const source::SymbolTable* symbols = nullptr);

}  // namespace merker::step5
