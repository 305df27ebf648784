// Bits, and bits of bytes: what is known of them without an operation.
#include <utility>

#include "icode/builder.h"

namespace merker::icode {

// The bit of the byte as it was assigned last; otherwise `byte` is an earlier one with the same
// bit.
std::optional<Value> Builder::assigned(Value& byte, std::uint32_t number) const {
  constexpr int kFar = 8;
  for (int i = 0; i < kFar && region_->ops[byte].code == Opcode::Insert; ++i) {
    const Op& op = region_->ops[byte];
    if (op.number == number) return op.b;
    byte = op.a;
  }
  return std::nullopt;
}

Value Builder::bitOf(Value byte, std::uint32_t number) {
  if (const auto bit = assigned(byte, number)) return *bit;
  return number == 0 ? byte : make(Opcode::BitOf, byte, kNoValue, number);  // only bit 0 counts
}

// A turn of a loop often assigns what the one before has assigned.
Value Builder::withBit(Value byte, Value bit, std::uint32_t number) {
  Value before = byte;
  return assigned(before, number) == bit ? byte : make(Opcode::Insert, byte, bit, number);
}

// An edge that is past: the memory of it holds the bit itself.
bool Builder::isNegation(Value bit, Value of) const {
  const auto plain = [this](Value value) {
    return region_->ops[value].code == Opcode::ToWord ? region_->ops[value].a : value;
  };
  return region_->ops[bit].code == Opcode::NotBit && plain(region_->ops[bit].a) == plain(of);
}

Value Builder::andBit(Value a, Value b) {
  if (number(a)) std::swap(a, b);
  if (const auto n = number(b)) return (*n & 1) != 0 ? a : b;
  if (isNegation(a, b) || isNegation(b, a)) return constant(0);
  return make(Opcode::AndBit, a, b);
}

Value Builder::orBit(Value a, Value b) {
  if (number(a)) std::swap(a, b);
  if (const auto n = number(b)) return (*n & 1) != 0 ? b : a;
  return make(Opcode::OrBit, a, b);
}

Value Builder::xorBit(Value a, Value b) {
  if (number(a)) std::swap(a, b);
  if (const auto n = number(b)) return (*n & 1) != 0 ? notBit(a) : a;
  return make(Opcode::XorBit, a, b);
}

Value Builder::notBit(Value a) {
  if (const auto n = number(a)) return constant(~*n & 1);
  if (region_->ops[a].code == Opcode::NotBit) return region_->ops[a].a;
  return make(Opcode::NotBit, a);
}

}  // namespace merker::icode
