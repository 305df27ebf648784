// Numbers as binary coded decimal (S7-INSTR-92 … -95).
#include "lowering/lowering.h"
#include "lowering/status.h"

namespace merker::translate {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc7::Operation;

// Six more for each ten, in the place of the tens.
Value toBcd(Lowering& l, Value number, unsigned digits) {
  icode::Builder& b = l.to;
  Value result = number;
  std::uint32_t power = 10;
  for (unsigned i = 1; i < digits; ++i, power *= 10) {
    const Value tens = b.make(Opcode::Div, number, b.constant(power));
    const Value more = b.make(Opcode::Mul, tens, b.constant(6u << (4 * (i - 1))));
    result = b.make(Opcode::Add, result, more);
  }
  return result;
}

Value fromBcd(Lowering& l, Value bcd, unsigned digits) {
  icode::Builder& b = l.to;
  Value result = bcd;
  std::uint32_t surplus = 6;
  for (unsigned i = 1; i < digits; ++i, surplus *= 10) {
    const Value tens = b.withNumber(Opcode::Shr, bcd, 4 * i);
    result = b.make(Opcode::Sub, result, b.make(Opcode::Mul, tens, b.constant(surplus)));
  }
  return result;
}

// With 6 added to each digit, one above 9 carries into the next. At most 7 digits.
Value isBcd(Lowering& l, Value bcd) {
  icode::Builder& b = l.to;
  const Value six = b.constant(0x0666'6666);
  const Value sum = b.make(Opcode::Add, bcd, six);
  const Value without = b.make(Opcode::Xor, bcd, six);
  const Value carries =
      b.make(Opcode::And, b.make(Opcode::Xor, sum, without), b.constant(0x1111'1110));
  return b.make(Opcode::Equal, carries, b.constant(0));
}

namespace {

Value negatedIf(Lowering& l, Value bit, Value number) {
  icode::Builder& b = l.to;
  const Value word = b.make(Opcode::ToWord, bit);
  const Value mask = b.make(Opcode::Neg, word);
  return b.make(Opcode::Add, b.make(Opcode::Xor, number, mask), word);
}

// Sign in the highest bit. A wrong digit is the interpreter's business.
template <unsigned Bits>
bool toNumber(Lowering& l) {
  icode::Builder& b = l.to;
  const Value accu = b.get(Item::Accu1);
  const Value bcd = b.make(Opcode::And, accu, b.constant(Bits == 16 ? 0xFFF : 0x0FFF'FFFF));
  b.guard(isBcd(l, bcd));
  const Value sign = b.withNumber(Opcode::BitOf, accu, Bits - 1);
  const Value number = negatedIf(l, sign, fromBcd(l, bcd, Bits / 4 - 1));
  b.set(Item::Accu1, Bits == 16 ? b.make(Opcode::LowFrom, accu, number) : number);
  return true;
}

// What has too many digits is the interpreter's business.
template <unsigned Bits>
bool toDecimal(Lowering& l) {
  constexpr std::uint32_t kMost = Bits == 16 ? 999 : 9'999'999;
  icode::Builder& b = l.to;
  const Value accu = b.get(Item::Accu1);
  const Value number = Bits == 16 ? b.make(Opcode::Sext16, accu) : accu;
  const Value shifted = b.make(Opcode::Add, number, b.constant(kMost));
  b.guard(b.make(Opcode::BelowEqual, shifted, b.constant(2 * kMost)));
  const Value negative = b.make(Opcode::Less, number, b.constant(0));
  const Value digits = toBcd(l, negatedIf(l, negative, number), Bits / 4 - 1);
  const Value sign =
      b.withNumber(Opcode::Shl, b.make(Opcode::Neg, b.make(Opcode::ToWord, negative)), Bits - 4);
  const Value result = b.make(Opcode::Or, digits, sign);
  b.set(Item::Accu1, Bits == 16 ? b.make(Opcode::LowFrom, accu, result) : result);
  setOverflow(l, b.constant(0));
  return true;
}

constexpr Row kBcdRows[] = {{Operation::BTI, toNumber<16>},
                            {Operation::BTD, toNumber<32>},
                            {Operation::ITB, toDecimal<16>},
                            {Operation::DTB, toDecimal<32>}};

}  // namespace

std::span<const Row> bcdRows() { return kBcdRows; }

}  // namespace merker::translate
