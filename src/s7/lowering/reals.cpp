// REAL (S7-INSTR-60 … -66, -74, -97 … -101). Whatever is no ordinary number is left to the
// interpreter.
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

// The bits of an ordinary REAL, seen as DINT, have its sign; -0 alone does not.
void setReal(Lowering& l, Value result) {
  icode::Builder& b = l.to;
  b.guard(b.make(Opcode::Ordinary, result));
  b.set(Item::Accu1, result);
  const Value zero = b.constant(0);
  b.set(Item::Cc0, b.make(Opcode::LessReal, result, zero));
  b.set(Item::Cc1, b.make(Opcode::LessReal, zero, result));
  setOverflow(l, b.constant(0));
}

template <Opcode Function>
bool binary(Lowering& l) {
  icode::Builder& b = l.to;
  setReal(l, b.make(Function, b.get(Item::Accu2), b.get(Item::Accu1)));
  dropOperand(l);
  return true;
}

template <Opcode Function, std::uint32_t Mask>
bool sign(Lowering& l) {
  l.to.set(Item::Accu1, l.to.make(Function, l.to.get(Item::Accu1), l.to.constant(Mask)));
  return true;
}

template <Relation R>
bool compare(Lowering& l) {
  icode::Builder& b = l.to;
  const Value x = b.get(Item::Accu2), y = b.get(Item::Accu1);
  b.guard(b.make(Opcode::Ordered, x, y));
  const Value less = b.make(Opcode::LessReal, x, y), greater = b.make(Opcode::LessReal, y, x);
  b.set(Item::Cc0, less);
  b.set(Item::Cc1, greater);
  b.set(Item::Ov, false);
  Value result = less;
  if constexpr (R == Relation::Equal) result = b.notBit(b.orBit(less, greater));
  if constexpr (R == Relation::NotEqual) result = b.orBit(less, greater);
  if constexpr (R == Relation::LessEqual) result = b.notBit(greater);
  if constexpr (R == Relation::Greater) result = greater;
  if constexpr (R == Relation::GreaterEqual) result = b.notBit(less);
  setComparison(l, result);
  return true;
}

bool fromDint(Lowering& l) {
  l.to.set(Item::Accu1, l.to.make(Opcode::RealOf, l.to.get(Item::Accu1)));
  return true;
}

bool square(Lowering& l) {
  const Value x = l.to.get(Item::Accu1);
  setReal(l, l.to.make(Opcode::MulReal, x, x));
  return true;
}

bool root(Lowering& l) {
  setReal(l, l.to.make(Opcode::RootReal, l.to.get(Item::Accu1)));
  return true;
}

// Inside ±2^30 no rounding can leave DINT.
enum class To : std::uint8_t { Nearest, Zero, Below, Above };

Value rounded(icode::Builder& b, Value number, To to) {
  if (to == To::Nearest) return b.make(Opcode::Round, number);
  const Value cut = b.make(Opcode::Truncate, number);
  if (to == To::Zero) return cut;
  const Value back = b.make(Opcode::RealOf, cut);
  if (to == To::Below)
    return b.make(Opcode::Sub, cut, b.make(Opcode::ToWord, b.make(Opcode::LessReal, number, back)));
  return b.make(Opcode::Add, cut, b.make(Opcode::ToWord, b.make(Opcode::LessReal, back, number)));
}

template <To Where>
bool toDint(Lowering& l) {
  constexpr std::uint32_t kMagnitude = 0x7FFF'FFFF, kLimit = 0x4E80'0000;  // 2^30
  icode::Builder& b = l.to;
  const Value number = b.get(Item::Accu1);
  b.guard(b.make(Opcode::Below, b.make(Opcode::And, number, b.constant(kMagnitude)),
                 b.constant(kLimit)));
  b.set(Item::Accu1, rounded(b, number, Where));
  setOverflow(l, b.constant(0));
  return true;
}

constexpr Row kRealsRows[] = {{Operation::ADD_R, binary<Opcode::AddReal>},
                              {Operation::SUB_R, binary<Opcode::SubReal>},
                              {Operation::MUL_R, binary<Opcode::MulReal>},
                              {Operation::DIV_R, binary<Opcode::DivReal>},
                              {Operation::NEGR, sign<Opcode::Xor, 0x8000'0000u>},
                              {Operation::ABS, sign<Opcode::And, 0x7FFF'FFFFu>},
                              {Operation::EQ_R, compare<Relation::Equal>},
                              {Operation::NE_R, compare<Relation::NotEqual>},
                              {Operation::LT_R, compare<Relation::Less>},
                              {Operation::LE_R, compare<Relation::LessEqual>},
                              {Operation::GT_R, compare<Relation::Greater>},
                              {Operation::GE_R, compare<Relation::GreaterEqual>},
                              {Operation::DTR, fromDint},
                              {Operation::RND, toDint<To::Nearest>},
                              {Operation::RND_MINUS, toDint<To::Below>},
                              {Operation::RND_PLUS, toDint<To::Above>},
                              {Operation::TRUNC, toDint<To::Zero>},
                              {Operation::SQR, square},
                              {Operation::SQRT, root}};

}  // namespace

std::span<const Row> realRows() { return kRealsRows; }

}  // namespace merker::translate
