#include "graph7/rules.h"

#include "mc7/operand.h"

namespace merker::graph7 {
namespace {

using graph::ElementClass;
using graph::ElementRow;
using graph::Eno;

constexpr ElementRow kRows[] = {
#define BOX(id, de, en, kind, eno, pattern) \
  {id, de, en, de, en, ElementClass::kind, Eno::eno, pattern, "", ""},
#define COIL(id, kopDe, kopEn, fupDe, fupEn, kind, pattern, sayDe, sayEn) \
  {id, kopDe, kopEn, fupDe, fupEn, ElementClass::kind, Eno::None, pattern, sayDe, sayEn},
#include "graph7/elements.inc"
#undef BOX
#undef COIL
};

graph::Operand status(mc7::StatusQuery query) {
  graph::Operand operand;
  operand.kind = graph::OperandKind::Status;
  operand.number = static_cast<std::uint32_t>(query);
  return operand;
}

}  // namespace

const graph::Rules& rules() {
  static const graph::ElementTable table(kRows);
  static const graph::Rules kRules{&table, 7, status(mc7::StatusQuery::BIE),
                                   status(mc7::StatusQuery::OV)};
  return kRules;
}

}  // namespace merker::graph7
