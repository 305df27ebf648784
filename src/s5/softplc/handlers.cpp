#include "softplc/handlers.h"

#include <array>

namespace merker::sinumerik {
namespace {

constexpr std::size_t kOperations = 0
#define OPERATION(...) +1
#include "mc5/operations.inc"
#undef OPERATION
    ;

std::array<Handler, kOperations> makeTable() {
  constexpr HandlerRows (*kFiles[])() = {
      bitHandlers,        loadHandlers,       cellHandlers,   compareHandlers,
      arithmeticHandlers, floatHandlers,      wordHandlers,   callHandlers,
      jumpHandlers,       conversionHandlers, systemHandlers, processingHandlers};
  std::array<Handler, kOperations> table{};
  table.fill(&substituteFormal);  // LW LD RB RD SVZ SSV SAR exist with formal operands only
  for (const auto file : kFiles)
    for (const HandlerRow& row : file())
      table[static_cast<std::size_t>(row.operation)] = row.handler;
  return table;
}

}  // namespace

Handler handler(const mc5::Instruction& instruction) {
  static const std::array<Handler, kOperations> kTable = makeTable();
  if (instruction.operand.kind == mc5::OperandKind::Formal) return &substituteFormal;
  return kTable[static_cast<std::size_t>(instruction.operation)];
}

}  // namespace merker::sinumerik
