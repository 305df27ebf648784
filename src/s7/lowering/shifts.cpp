// Shifts and rotations (S7-INSTR-75 … -84). A count in AKKU2 of 0, or beyond the bits there are, is
// left to the interpreter.
#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc7::Operation;

// A1 = last bit shifted out, A0 and OV 0.
void setShifted(Lowering& l, Value last) {
  l.to.set(Item::Cc1, last);
  l.to.set(Item::Cc0, false);
  l.to.set(Item::Ov, false);
}

void setResult(Lowering& l, unsigned bits, Value result) {
  l.to.set(Item::Accu1,
           bits == 32 ? result : l.to.make(Opcode::LowFrom, l.to.get(Item::Accu1), result));
}

Value bit(Lowering& l, Value word, std::uint32_t n) {
  return l.to.withNumber(Opcode::BitOf, word, n);
}

bool isByAccu(const Lowering& l) { return l.operand().kind == mc7::OperandKind::None; }

// 1 to the highest; as long as nothing is set.
Value countInAccu(Lowering& l, std::uint32_t highest) {
  icode::Builder& b = l.to;
  const Value count = b.make(Opcode::And, b.get(Item::Accu2), b.constant(0xFF));
  const Value below = b.make(Opcode::Sub, count, b.constant(1));
  b.guard(b.make(Opcode::Below, below, b.constant(highest)));
  return count;
}

template <unsigned Bits>
bool leftByAccu(Lowering& l) {
  icode::Builder& b = l.to;
  const Value count = countInAccu(l, Bits - 1), before = b.get(Item::Accu1);
  setShifted(l, b.make(Opcode::BitAt, before, b.make(Opcode::Sub, b.constant(Bits), count)));
  setResult(l, Bits, b.make(Opcode::ShlBy, before, count));
  return true;
}

template <unsigned Bits, bool Signed>
bool rightByAccu(Lowering& l) {
  icode::Builder& b = l.to;
  const Value count = countInAccu(l, Bits - 1), accu = b.get(Item::Accu1);
  const Value before = Bits == 32 ? accu : b.make(Signed ? Opcode::Sext16 : Opcode::Zext16, accu);
  setShifted(l, b.make(Opcode::BitAt, before, b.make(Opcode::Sub, count, b.constant(1))));
  setResult(l, Bits, b.make(Signed ? Opcode::SarBy : Opcode::ShrBy, before, count));
  return true;
}

template <bool Left>
bool rotateByAccu(Lowering& l) {
  icode::Builder& b = l.to;
  const Value count = countInAccu(l, 0xFF);
  const Value turn = Left ? count : b.make(Opcode::Sub, b.constant(32), count);
  const Value by = b.make(Opcode::And, turn, b.constant(31));
  const Value result = b.make(Opcode::RotlBy, b.get(Item::Accu1), by);
  b.set(Item::Accu1, result);
  setShifted(l, bit(l, result, Left ? 0 : 31));
  return true;
}

template <unsigned Bits>
bool left(Lowering& l) {
  if (isByAccu(l)) return leftByAccu<Bits>(l);
  const std::uint32_t count = l.operand().value;
  if (count == 0) return true;
  const Value before = l.to.get(Item::Accu1), zero = l.to.constant(0);
  setShifted(l, count > Bits ? zero : bit(l, before, Bits - count));
  setResult(l, Bits, count >= Bits ? zero : l.to.withNumber(Opcode::Shl, before, count));
  return true;
}

template <unsigned Bits>
bool right(Lowering& l) {
  if (isByAccu(l)) return rightByAccu<Bits, false>(l);
  const std::uint32_t count = l.operand().value;
  if (count == 0) return true;
  const Value accu = l.to.get(Item::Accu1), zero = l.to.constant(0);
  const Value before = Bits == 16 ? l.to.make(Opcode::Zext16, accu) : accu;
  setShifted(l, count > Bits ? zero : bit(l, before, count - 1));
  setResult(l, Bits, count >= Bits ? zero : l.to.withNumber(Opcode::Shr, before, count));
  return true;
}

template <unsigned Bits>
bool rightSigned(Lowering& l) {
  if (isByAccu(l)) return rightByAccu<Bits, true>(l);
  const std::uint32_t count = std::min<std::uint32_t>(l.operand().value, Bits);
  if (count == 0) return true;
  const Value accu = l.to.get(Item::Accu1);
  const Value before = Bits == 16 ? l.to.make(Opcode::Sext16, accu) : accu;
  setShifted(l, bit(l, before, count - 1));
  setResult(l, Bits, l.to.withNumber(Opcode::Sar, before, std::min(count, 31u)));
  return true;
}

template <bool Left>
bool rotate(Lowering& l) {
  if (isByAccu(l)) return rotateByAccu<Left>(l);
  if (l.operand().value == 0) return true;
  const std::uint32_t turn = l.operand().value % 32;
  const Value result =
      l.to.withNumber(Opcode::Rotl, l.to.get(Item::Accu1), Left ? turn : (32 - turn) % 32);
  l.to.set(Item::Accu1, result);
  setShifted(l, bit(l, result, Left ? 0 : 31));
  return true;
}

template <bool Left>
bool throughA1(Lowering& l) {
  icode::Builder& b = l.to;
  const Value accu = b.get(Item::Accu1), carried = b.make(Opcode::ToWord, b.get(Item::Cc1));
  const Value moved = b.withNumber(Left ? Opcode::Shl : Opcode::Shr, accu, 1);
  const Value filled = Left ? carried : b.withNumber(Opcode::Shl, carried, 31);
  b.set(Item::Accu1, b.make(Opcode::Or, moved, filled));
  setShifted(l, bit(l, accu, Left ? 31 : 0));
  return true;
}

constexpr Row kShiftsRows[] = {
    {Operation::SLW, left<16>},         {Operation::SLD, left<32>},
    {Operation::SRW, right<16>},        {Operation::SRD, right<32>},
    {Operation::SSI, rightSigned<16>},  {Operation::SSD, rightSigned<32>},
    {Operation::RLD, rotate<true>},     {Operation::RRD, rotate<false>},
    {Operation::RLDA, throughA1<true>}, {Operation::RRDA, throughA1<false>}};

}  // namespace

std::span<const Row> shiftRows() { return kShiftsRows; }

}  // namespace merker::translate
