// Load, transfer, exchange, no-operations (9.3.3, 9.3.9, 9.4.14).
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Item;
using icode::Value;
using mc5::Operation;

bool load(Lowering& l) {
  const auto value = readOperand(l);
  if (!value) return false;
  l.to.set(Item::Accu2, l.to.get(Item::Accu1));
  l.to.set(Item::Accu1, *value);
  return true;
}

bool transfer(Lowering& l) { return writeOperand(l, l.to.get(Item::Accu1)); }

bool exchange(Lowering& l) {
  const Value first = l.to.get(Item::Accu1);
  l.to.set(Item::Accu1, l.to.get(Item::Accu2));
  l.to.set(Item::Accu2, first);
  return true;
}

bool nothing(Lowering&) { return true; }

constexpr Row kMovesRows[] = {{Operation::LOAD, load},    {Operation::TRANSFER, transfer},
                              {Operation::TAK, exchange}, {Operation::NOP0, nothing},
                              {Operation::NOP1, nothing}, {Operation::BLD, nothing}};

}  // namespace

std::span<const Row> moveRows() { return kMovesRows; }

}  // namespace merker::translate5
