// INT and DINT arithmetic, comparisons, word logic, ITD (S7-INSTR-12 … -17, -51 … -59, -71 … -73).
#include "check/check.h"
#include "lowering/lowering.h"
#include "lowering/status.h"

namespace merker::translate {
namespace {

using block::Relation;
using icode::Item;
using icode::Opcode;
using icode::Value;
using mc7::Operation;

Value low(Lowering& l, Item accu) { return l.to.make(Opcode::Sext16, l.to.get(accu)); }
void setLow(Lowering& l, Value value) {
  l.to.set(Item::Accu1, l.to.make(Opcode::LowFrom, l.to.get(Item::Accu1), value));
}

// The result wraps; A1 A0 are those of the wrapped number.
void wrap(Lowering& l, Value exact) {
  setLow(l, exact);
  const Value wrapped = l.to.make(Opcode::Sext16, exact);
  setSign(l, wrapped);
  setOverflow(l, l.to.make(Opcode::NotEqual, wrapped, exact));
}

template <Opcode Function>
bool integer(Lowering& l) {
  wrap(l, l.to.make(Function, low(l, Item::Accu2), low(l, Item::Accu1)));
  dropOperand(l);
  return true;
}

bool multiply(Lowering& l) {
  const Value product = l.to.make(Opcode::Mul, low(l, Item::Accu2), low(l, Item::Accu1));
  l.to.set(Item::Accu1, product);
  setSign(l, product);
  setOverflow(l, l.to.make(Opcode::NotEqual, l.to.make(Opcode::Sext16, product), product));
  dropOperand(l);
  return true;
}

// By 0 and by -1, where the quotient may not fit, is left to the interpreter.
void guardDivisor(Lowering& l, Value divisor) {
  const Value next = l.to.make(Opcode::Add, divisor, l.to.constant(1));
  l.to.guard(l.to.make(Opcode::Below, l.to.constant(1), next));
}

bool divide(Lowering& l) {
  icode::Builder& b = l.to;
  const Value dividend = low(l, Item::Accu2), divisor = low(l, Item::Accu1);
  guardDivisor(l, divisor);
  const Value quotient = b.make(Opcode::Div, dividend, divisor);
  const Value rest = b.make(Opcode::Mod, dividend, divisor);
  b.set(Item::Accu1, b.make(Opcode::LowFrom, b.withNumber(Opcode::Shl, rest, 16), quotient));
  setSign(l, quotient);
  setOverflow(l, b.constant(0));
  dropOperand(l);
  return true;
}

template <Opcode Function, Opcode Overflow>
bool doubleInteger(Lowering& l) {
  icode::Builder& b = l.to;
  const Value x = b.get(Item::Accu2), y = b.get(Item::Accu1);
  const Value result = b.make(Function, x, y);
  b.set(Item::Accu1, result);
  setSign(l, result);
  setOverflow(l, b.make(Overflow, x, y));
  dropOperand(l);
  return true;
}

// The sign is that of the true product, also when it overflows.
bool multiplyDouble(Lowering& l) {
  icode::Builder& b = l.to;
  const Value x = b.get(Item::Accu2), y = b.get(Item::Accu1);
  const Value product = b.make(Opcode::Mul, x, y), high = b.make(Opcode::MulHigh, x, y);
  const Value zero = b.constant(0),
              none = b.make(Opcode::Equal, b.make(Opcode::Or, product, high), zero);
  const Value negative = b.make(Opcode::Less, high, zero);
  b.set(Item::Accu1, product);
  b.set(Item::Cc0, negative);
  b.set(Item::Cc1, b.notBit(b.orBit(negative, none)));
  setOverflow(l, b.make(Opcode::MulOverflows, x, y));
  dropOperand(l);
  return true;
}

template <Opcode Function>
bool divideDouble(Lowering& l) {
  icode::Builder& b = l.to;
  const Value divisor = b.get(Item::Accu1);
  guardDivisor(l, divisor);
  const Value result = b.make(Function, b.get(Item::Accu2), divisor);
  b.set(Item::Accu1, result);
  setSign(l, result);
  setOverflow(l, b.constant(0));
  dropOperand(l);
  return true;
}

bool addConstant(Lowering& l) {
  const Value sum = l.to.make(Opcode::Add, l.to.get(Item::Accu1), l.to.constant(l.operand().value));
  if (bitWidth(l.operand().format) == 32)
    l.to.set(Item::Accu1, sum);
  else
    setLow(l, sum);
  return true;
}

bool negateInt(Lowering& l) {
  wrap(l, l.to.make(Opcode::Neg, low(l, Item::Accu1)));
  return true;
}

bool negateDint(Lowering& l) {
  icode::Builder& b = l.to;
  const Value before = b.get(Item::Accu1), result = b.make(Opcode::Neg, before);
  b.set(Item::Accu1, result);
  setSign(l, result);
  setOverflow(l, b.make(Opcode::SubOverflows, b.constant(0), before));
  return true;
}

bool invertInt(Lowering& l) {
  l.to.set(Item::Accu1, l.to.make(Opcode::Xor, l.to.get(Item::Accu1), l.to.constant(0xFFFF)));
  return true;
}

bool invertDint(Lowering& l) {
  l.to.set(Item::Accu1, l.to.make(Opcode::Not, l.to.get(Item::Accu1)));
  return true;
}

bool extend(Lowering& l) {
  l.to.set(Item::Accu1, low(l, Item::Accu1));
  return true;
}

template <Relation R>
Value holds(Lowering& l, Value a, Value b) {
  if constexpr (R == Relation::Equal) return l.to.make(Opcode::Equal, a, b);
  if constexpr (R == Relation::NotEqual) return l.to.make(Opcode::NotEqual, a, b);
  if constexpr (R == Relation::Less) return l.to.make(Opcode::Less, a, b);
  if constexpr (R == Relation::LessEqual) return l.to.make(Opcode::LessEqual, a, b);
  if constexpr (R == Relation::Greater) return l.to.make(Opcode::Less, b, a);
  return l.to.make(Opcode::LessEqual, b, a);
}

template <Relation R, bool Double>
bool compare(Lowering& l) {
  icode::Builder& b = l.to;
  const Value x = Double ? b.get(Item::Accu2) : low(l, Item::Accu2);
  const Value y = Double ? b.get(Item::Accu1) : low(l, Item::Accu1);
  b.set(Item::Cc0, b.make(Opcode::Less, x, y));
  b.set(Item::Cc1, b.make(Opcode::Less, y, x));
  b.set(Item::Ov, false);
  setComparison(l, holds<R>(l, x, y));
  return true;
}

// A1 = (result not 0), A0 and OV 0.
void setLogic(Lowering& l, Value result) {
  l.to.set(Item::Cc1, l.to.make(Opcode::NotEqual, result, l.to.constant(0)));
  l.to.set(Item::Cc0, false);
  l.to.set(Item::Ov, false);
}

template <Opcode Function, bool Double>
bool wordLogic(Lowering& l) {
  icode::Builder& b = l.to;
  const bool constant = l.operand().kind == mc7::OperandKind::Constant;
  const Value other = constant ? b.constant(l.operand().value) : b.get(Item::Accu2);
  const Value result = b.make(Function, b.get(Item::Accu1), other);
  if constexpr (Double) {
    b.set(Item::Accu1, result);
    setLogic(l, result);
  } else {
    setLow(l, result);
    setLogic(l, b.make(Opcode::Zext16, result));
  }
  return true;
}

template <bool Double>
constexpr Row comparison(Relation relation, Operation operation) {
  constexpr Lower kFunctions[] = {
      compare<Relation::Equal, Double>,   compare<Relation::NotEqual, Double>,
      compare<Relation::Less, Double>,    compare<Relation::LessEqual, Double>,
      compare<Relation::Greater, Double>, compare<Relation::GreaterEqual, Double>};
  return {operation, kFunctions[static_cast<std::size_t>(relation)]};
}

constexpr Row kNumbersRows[] = {
    {Operation::ADD_I, integer<Opcode::Add>},
    {Operation::SUB_I, integer<Opcode::Sub>},
    {Operation::MUL_I, multiply},
    {Operation::DIV_I, divide},
    {Operation::ADD_D, doubleInteger<Opcode::Add, Opcode::AddOverflows>},
    {Operation::SUB_D, doubleInteger<Opcode::Sub, Opcode::SubOverflows>},
    {Operation::MUL_D, multiplyDouble},
    {Operation::DIV_D, divideDouble<Opcode::Div>},
    {Operation::MOD, divideDouble<Opcode::Mod>},
    {Operation::ADD_CONSTANT, addConstant},
    {Operation::NEGI, negateInt},
    {Operation::NEGD, negateDint},
    {Operation::INVI, invertInt},
    {Operation::INVD, invertDint},
    {Operation::ITD, extend},
    comparison<false>(Relation::Equal, Operation::EQ_I),
    comparison<false>(Relation::NotEqual, Operation::NE_I),
    comparison<false>(Relation::Less, Operation::LT_I),
    comparison<false>(Relation::LessEqual, Operation::LE_I),
    comparison<false>(Relation::Greater, Operation::GT_I),
    comparison<false>(Relation::GreaterEqual, Operation::GE_I),
    comparison<true>(Relation::Equal, Operation::EQ_D),
    comparison<true>(Relation::NotEqual, Operation::NE_D),
    comparison<true>(Relation::Less, Operation::LT_D),
    comparison<true>(Relation::LessEqual, Operation::LE_D),
    comparison<true>(Relation::Greater, Operation::GT_D),
    comparison<true>(Relation::GreaterEqual, Operation::GE_D),
    {Operation::AND_W, wordLogic<Opcode::And, false>},
    {Operation::OR_W, wordLogic<Opcode::Or, false>},
    {Operation::XOR_W, wordLogic<Opcode::Xor, false>},
    {Operation::AND_D, wordLogic<Opcode::And, true>},
    {Operation::OR_D, wordLogic<Opcode::Or, true>},
    {Operation::XOR_D, wordLogic<Opcode::Xor, true>}};

}  // namespace

std::span<const Row> numberRows() { return kNumbersRows; }

}  // namespace merker::translate
