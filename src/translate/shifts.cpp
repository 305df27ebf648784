// Shifts and rotations with the count in the instruction (S7-INSTR-75 … -84). A count in AKKU2 is
// left to the interpreter.
#include "translate/lowering.h"

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

template <unsigned Bits>
bool left(Lowering& l) {
  if (l.operand().kind == mc7::OperandKind::None) return false;
  const std::uint32_t count = l.operand().value;
  if (count == 0) return true;
  const Value before = l.to.get(Item::Accu1), zero = l.to.constant(0);
  setShifted(l, count > Bits ? zero : bit(l, before, Bits - count));
  setResult(l, Bits, count >= Bits ? zero : l.to.withNumber(Opcode::Shl, before, count));
  return true;
}

template <unsigned Bits>
bool right(Lowering& l) {
  if (l.operand().kind == mc7::OperandKind::None) return false;
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
  if (l.operand().kind == mc7::OperandKind::None) return false;
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
  if (l.operand().kind == mc7::OperandKind::None) return false;
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

constexpr Row kRows[] = {{Operation::SLW, left<16>},         {Operation::SLD, left<32>},
                         {Operation::SRW, right<16>},        {Operation::SRD, right<32>},
                         {Operation::SSI, rightSigned<16>},  {Operation::SSD, rightSigned<32>},
                         {Operation::RLD, rotate<true>},     {Operation::RRD, rotate<false>},
                         {Operation::RLDA, throughA1<true>}, {Operation::RRDA, throughA1<false>}};

}  // namespace

std::span<const Row> shiftRows() { return kRows; }

}  // namespace merker::translate
