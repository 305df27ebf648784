// Operands in a listing: E 10.3, EW20, D 5.15, T 17, KH 7F0A, KF +5, DB 10, =EIN, 16.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "mc5/operand.h"
#include "source/symbol_table.h"
#include "step5/scanner.h"

namespace merker::step5 {

struct Operand {
  mc5::Operand value;
  std::string name;     // of a formal operand or a jump label; `value` is then of kind None
  bool symbol = false;  // -START: `value` is what it stands for
  std::size_t offset = 0, length = 0;  // in the file
};

// Reads the longest operand; what follows it stays in the scanner. Problems carry the place as
// offset and length.
struct Failure {
  ProblemCode code;
  std::size_t offset = 0, length = 1;
  std::string what, expected;
};

// Whether the word of an operand stands here: in capital letters (E, MW, KF), or with its number
// behind it. Other words are free text.
bool beginsOperand(Scanner scanner);
// -START: a name of an assignment list.
bool beginsSymbol(const Scanner& scanner);
// - START and "START", too; names such as -1S3 may begin with a digit.
bool isSymbolMark(Scanner scanner);
// -START; "AUF ZU" where the name would end too early.
std::string symbolText(std::string_view name);
std::optional<Operand> parseOperand(Scanner& scanner, Failure& failure,
                                    const source::SymbolTable* symbols = nullptr);

}  // namespace merker::step5
