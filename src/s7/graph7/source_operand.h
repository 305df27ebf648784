// Operands as a source text of STEP 7 names them. What does not compile is shown, too: a symbol
// that nobody has declared, an operand that is still missing.
#pragma once

#include "graph/statement.h"
#include "step7/interfaces.h"
#include "step7/operand_parser.h"

namespace merker::graph7 {

// The first bit behind the declared temporary variables.
BitAddress behindTemps(const block::Block& block);

class SourceOperands {
 public:
  // `block`: whose names are visible. All must outlive it.
  SourceOperands(const source::SourceFile& file, const block::Block& block, Mnemonics mnemonics,
                 step7::Interfaces& interfaces, const step7::CompileOptions& options);

  // The operand at the cursor, which then stands behind it.
  graph::Operand read(step7::Cursor& cursor, mc7::Operation operation) const;
  // Nothing if no operand that can be resolved stands at the cursor.
  std::optional<step7::Access> parse(step7::Cursor& cursor) const;
  // As `read`, of a text that is no part of the file; nothing if more than an operand stands there.
  std::optional<graph::Operand> of(std::string_view text) const;
  // As `parse`, of such a text.
  std::optional<step7::Access> alone(std::string_view text) const;

  const step7::Scope& scope() const { return scope_; }
  BitAddress wires() const { return wires_; }
  bool isWire(const mc7::Operand& operand) const;

 private:
  graph::Operand resolved(const step7::Access& access, mc7::Operation operation) const;

  step7::Scope scope_;
  BitAddress wires_;
};

// The bit behind an absolute operand of the local data; 0 for others.
BitAddress behindLocal(const graph::Operand& operand);
// L STW and T STW are operations of their own.
bool isStatusWord(const graph::Operand& operand);
// The data block that AUF DB 5 opens.
std::optional<std::uint32_t> dataBlockOf(const graph::Statement& statement);
// Makes DB5.DBW 2 of DBW 2; false if it is nothing of an open data block.
bool openDataBlock(graph::Operand& operand, std::uint32_t db);

// Without what does not matter for its meaning: blanks, case.
std::string normalized(std::string_view text);

}  // namespace merker::graph7
