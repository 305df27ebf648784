// Condition codes that several families of instructions set the same way.
#pragma once

#include "lowering/lowering.h"

namespace merker::translate {

// A1 A0 by sign: 00 zero, 01 negative, 10 positive.
inline void setSign(Lowering& l, icode::Value number) {
  const icode::Value zero = l.to.constant(0);
  l.to.set(icode::Item::Cc0, l.to.make(icode::Opcode::Less, number, zero));
  l.to.set(icode::Item::Cc1, l.to.make(icode::Opcode::Less, zero, number));
}

// OV as told; OS keeps an earlier overflow.
inline void setOverflow(Lowering& l, icode::Value overflow) {
  l.to.set(icode::Item::Ov, overflow);
  l.to.set(icode::Item::Os, l.to.orBit(l.to.get(icode::Item::Os), overflow));
}

inline void setComparison(Lowering& l, icode::Value result) {
  l.to.set(icode::Item::Rlo, result);
  l.to.set(icode::Item::Sta, result);
  l.to.set(icode::Item::Or, false);
  l.to.set(icode::Item::Er, true);
}

// CPUs with four accumulators: an operation on two operands lets accumulators 3 and 4 move down.
inline void dropOperand(Lowering& l) {
  if (l.model.accumulators != 4) return;
  l.to.set(icode::Item::Accu2, l.to.get(icode::Item::Accu3));
  l.to.set(icode::Item::Accu3, l.to.get(icode::Item::Accu4));
}

}  // namespace merker::translate
