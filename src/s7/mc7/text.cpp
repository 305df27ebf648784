#include <fmt/format.h>

#include "mc7/instruction.h"
#include "mc7/operand_text.h"

namespace merker::mc7 {

std::string text(const Instruction& instruction, Mnemonics mnemonics) {
  const OperationInfo& row = info(instruction.operation);
  const std::string_view mnemonic = mnemonics == Mnemonics::German ? row.de : row.en;
  const std::string operand = operandText(instruction, mnemonics);
  if (operand.empty()) return std::string{mnemonic};
  return fmt::format("{:<5} {}", mnemonic, operand);
}

}  // namespace merker::mc7
