#include "graph/missing.h"

namespace merker::graph {

Operand missing(std::string_view text) {
  Operand operand;
  operand.kind = OperandKind::Number;
  operand.code = operand.text = text;
  return operand;
}

bool isMissing(const Operand& operand) {
  return std::string_view(operand.text).starts_with(kMissingBegin);
}

}  // namespace merker::graph
