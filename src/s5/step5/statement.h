// One statement of a listing: operation and operand, as far as its own text tells.
#pragma once

#include <optional>
#include <string>

#include "mc5/instruction.h"
#include "step5/operand.h"

namespace merker::step5 {

struct Statement {
  mc5::Instruction instruction;
  std::string name;        // label of a jump or formal operand: `instruction` waits for its number
  std::size_t offset = 0;  // of the operation in the file
  std::size_t operandOffset = 0, operandLength = 0;
  std::optional<Failure> warning;
};

// Skips the colon in front of a statement. ":F" and ":G" are divisions, ":F T 5" is F T 5.
void skipColon(Scanner& scanner);

// Reads a statement; the rest of the line, a comment or nothing, stays in the scanner.
std::optional<Statement> parseStatement(Scanner& scanner, Failure& failure,
                                        const source::SymbolTable* symbols = nullptr);

}  // namespace merker::step5
