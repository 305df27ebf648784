// Fixed point arithmetic, comparisons, word logic, shifts (9.3.5, 9.3.8, 9.4.7 … 9.4.10).
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc5::Operation;

Value accu(Lowering& l) { return l.to.get(Item::Accu1); }
Value low(Lowering& l, Item item) { return l.to.make(Opcode::Sext16, l.to.get(item)); }
Value less(Lowering& l, Value a, Value b) { return l.to.make(Opcode::Less, a, b); }

void setLow(Lowering& l, Value value) {
  l.to.set(Item::Accu1, l.to.make(Opcode::LowFrom, accu(l), value));
}
void setAnz(Lowering& l, Value high, Value lowBit) {
  l.to.set(Item::Cc1, high);
  l.to.set(Item::Cc0, lowBit);
}
void setSign(Lowering& l, Value number) {
  const Value zero = l.to.constant(0);
  setAnz(l, less(l, zero, number), less(l, number, zero));
}
void setOverflow(Lowering& l, Value over) {
  l.to.set(Item::Ov, over);
  l.to.set(Item::Os, l.to.orBit(l.to.get(Item::Os), over));
}

// Akku 1-H is the sign of a result that fits, 0 after an overflow (S5-ARITH-03, OP-35).
Value put(Lowering& l, Value value) {
  icode::Builder& b = l.to;
  const Value rest = b.make(Opcode::Sext16, value);
  const Value over = b.make(Opcode::NotEqual, rest, value);
  const Value gone =
      b.withNumber(Opcode::Shl, b.make(Opcode::Neg, b.make(Opcode::ToWord, over)), 16);
  b.set(Item::Accu1, b.make(Opcode::And, rest, b.make(Opcode::Not, gone)));
  setOverflow(l, over);
  return over;
}

// ANZ is the sign of the 16 bits that remain (S5-STAT-07).
template <Opcode Function>
bool sum(Lowering& l) {
  const Value value = l.to.make(Function, low(l, Item::Accu2), low(l, Item::Accu1));
  put(l, value);
  setSign(l, l.to.make(Opcode::Sext16, value));
  return true;
}

// Beyond the range ANZ shows the other sign (S5-STAT-T1); such a product is never 0.
bool multiply(Lowering& l) {
  icode::Builder& b = l.to;
  const Value value = b.make(Opcode::Mul, low(l, Item::Accu2), low(l, Item::Accu1));
  const Value over = put(l, value), zero = b.constant(0);
  setAnz(l, b.xorBit(over, less(l, zero, value)), b.xorBit(over, less(l, value, zero)));
  return true;
}

// Quotient in Akku 1-L, remainder in Akku 1-H (S5-ARITH-04). By 0 and by -1, where the quotient may
// not fit, is left to the processor.
bool divide(Lowering& l) {
  if (!l.mayLeave()) return false;
  icode::Builder& b = l.to;
  const Value dividend = low(l, Item::Accu2), divisor = low(l, Item::Accu1);
  const Value next = b.make(Opcode::Add, divisor, b.constant(1));
  b.guard(b.make(Opcode::Below, b.constant(1), next));
  const Value quotient = b.make(Opcode::Div, dividend, divisor);
  const Value rest = b.make(Opcode::Mod, dividend, divisor);
  b.set(Item::Accu1, b.make(Opcode::LowFrom, b.withNumber(Opcode::Shl, rest, 16), quotient));
  setSign(l, quotient);
  setOverflow(l, b.constant(0));
  return true;
}

bool addConstant(Lowering& l) {
  const mc5::Operand& operand = l.operand();
  const int value = operand.format == mc5::Format::SignedByte
                        ? static_cast<std::int8_t>(operand.value)
                        : static_cast<std::int16_t>(operand.value);
  const Value by = l.to.constant(static_cast<std::uint32_t>(value));
  setLow(l, l.to.make(Opcode::Add, accu(l), by));
  return true;
}

// Only the low byte, without carry (S5-INCDEC-01).
template <Opcode Function>
bool count(Lowering& l) {
  const Value counted = l.to.make(Function, accu(l), l.to.constant(l.operand().value));
  l.to.set(Item::Accu1, l.to.make(Opcode::ByteFrom, accu(l), counted));
  return true;
}

// S5-CMP: AKKU 2 with AKKU 1.
template <Opcode Relation, bool Exchanged, bool Double>
bool compare(Lowering& l) {
  const Value left = Double ? l.to.get(Item::Accu2) : low(l, Item::Accu2);
  const Value right = Double ? accu(l) : low(l, Item::Accu1);
  const Value truth = l.to.make(Relation, Exchanged ? right : left, Exchanged ? left : right);
  setAnz(l, less(l, right, left), less(l, left, right));
  l.to.set(Item::Ov, false);
  l.to.set(Item::Rlo, truth);
  l.to.set(Item::Sta, truth);
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, true);
  return true;
}

// Logic and shifts: OV is 0, ANZ1 tells, ANZ0 is 0.
void judge(Lowering& l, Value bit) {
  setAnz(l, bit, l.to.constant(0));
  l.to.set(Item::Ov, false);
}

template <Opcode Function>
bool logic(Lowering& l) {
  const Value result = l.to.make(Function, l.to.get(Item::Accu2), accu(l));
  setLow(l, result);
  judge(l, l.to.make(Opcode::NotEqual, l.to.make(Opcode::Zext16, result), l.to.constant(0)));
  return true;
}

// ANZ 1 is the bit shifted out last (S5-SHIFT-02); by 0 nothing happens, in the shorter time.
template <Opcode Function, bool Double>
bool shift(Lowering& l) {
  const std::uint32_t by = l.operand().value, bits = Double ? 32 : 16;
  if (by == 0) return l.to.cost(static_cast<std::uint64_t>(l.times().shortest.ns)), true;
  constexpr Opcode kWiden = Function == Opcode::Sar ? Opcode::Sext16 : Opcode::Zext16;
  const Value before = Double ? accu(l) : l.to.make(kWiden, accu(l));
  const std::uint32_t last = Function == Opcode::Shl ? bits - by : by - 1;
  Value result = l.to.constant(0);
  if (by < 32)
    result = l.to.withNumber(Function, before, by);
  else if (Function == Opcode::Sar)
    result = l.to.withNumber(Function, before, 31);
  const Value out = l.to.withNumber(Opcode::BitOf, before, last);
  if (Double)
    l.to.set(Item::Accu1, result);
  else
    setLow(l, result);
  judge(l, out);
  return true;
}

bool complement(Lowering& l) {
  setLow(l, l.to.make(Opcode::Not, accu(l)));
  return true;
}

template <bool Double>
bool negate(Lowering& l) {
  const Value negative = l.to.make(Opcode::Neg, accu(l));
  const Value result = Double ? negative : l.to.make(Opcode::Sext16, negative);
  const Value lowest = l.to.constant(Double ? 0x80000000 : 0xFFFF8000);
  if (Double)
    l.to.set(Item::Accu1, result);
  else
    setLow(l, result);
  setSign(l, result);
  setOverflow(l, l.to.make(Opcode::Equal, result, lowest));
  return true;
}

constexpr Row kNumbersRows[] = {
    {Operation::ADD_F, sum<Opcode::Add>},
    {Operation::SUB_F, sum<Opcode::Sub>},
    {Operation::MUL_F, multiply},
    {Operation::DIV_F, divide},
    {Operation::ADD_BYTE, addConstant},
    {Operation::ADD_WORD, addConstant},
    {Operation::INCREMENT, count<Opcode::Add>},
    {Operation::DECREMENT, count<Opcode::Sub>},
    {Operation::EQUAL_F, compare<Opcode::Equal, false, false>},
    {Operation::UNEQUAL_F, compare<Opcode::NotEqual, false, false>},
    {Operation::GREATER_F, compare<Opcode::Less, true, false>},
    {Operation::GREATER_EQUAL_F, compare<Opcode::LessEqual, true, false>},
    {Operation::LESS_F, compare<Opcode::Less, false, false>},
    {Operation::LESS_EQUAL_F, compare<Opcode::LessEqual, false, false>},
    {Operation::EQUAL_D, compare<Opcode::Equal, false, true>},
    {Operation::UNEQUAL_D, compare<Opcode::NotEqual, false, true>},
    {Operation::GREATER_D, compare<Opcode::Less, true, true>},
    {Operation::GREATER_EQUAL_D, compare<Opcode::LessEqual, true, true>},
    {Operation::LESS_D, compare<Opcode::Less, false, true>},
    {Operation::LESS_EQUAL_D, compare<Opcode::LessEqual, false, true>},
    {Operation::AND_W, logic<Opcode::And>},
    {Operation::OR_W, logic<Opcode::Or>},
    {Operation::XOR_W, logic<Opcode::Xor>},
    {Operation::SHIFT_LEFT_W, shift<Opcode::Shl, false>},
    {Operation::SHIFT_RIGHT_W, shift<Opcode::Shr, false>},
    {Operation::SHIFT_SIGN_W, shift<Opcode::Sar, false>},
    {Operation::SHIFT_LEFT_D, shift<Opcode::Shl, true>},
    {Operation::SHIFT_SIGN_D, shift<Opcode::Sar, true>},
    {Operation::COMPLEMENT_W, complement},
    {Operation::NEGATE_W, negate<false>},
    {Operation::NEGATE_D, negate<true>}};

}  // namespace

std::span<const Row> numberRows() { return kNumbersRows; }

}  // namespace merker::translate5
