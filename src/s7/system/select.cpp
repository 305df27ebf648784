// FC 22 LIMIT, 25 MAX, 27 MIN, 36 SEL (S7-IEC-08): parameters of type ANY that must have the same
// type.
#include <bit>
#include <cmath>
#include <cstring>

#include "base/bytes.h"
#include "system/call.h"

namespace merker::system {
namespace {

struct Value {
  AnyPointer where;
  double number = 0;
  bool valid = false;
};

double number(TypeCode type, const std::uint8_t* bytes) {
  if (type == TypeCode::Int) return static_cast<std::int16_t>(loadWord(bytes));
  if (type == TypeCode::DInt) return static_cast<std::int32_t>(loadDWord(bytes));
  return static_cast<double>(std::bit_cast<float>(loadDWord(bytes)));
}

bool isNumber(TypeCode type) {
  return type == TypeCode::Int || type == TypeCode::DInt || type == TypeCode::Real;
}

Value get(Arguments& a, const AnyPointer& where) {
  Value value{.where = where};
  const TypeCode type = value.where.type;
  if (!isNumber(type)) return value;
  const Region bytes = a.region(value.where, type == TypeCode::Int ? 2 : 4, cpu::Access::Read);
  if (!bytes) return value;
  value.number = number(type, bytes.data);
  value.valid = !std::isnan(value.number);
  return value;
}

// Copies what `from` names to RET_VAL, which must have the same type.
template <typename A>
void put(A& a, const AnyPointer& from) {
  const AnyPointer target = a.any("RET_VAL");
  const std::uint32_t bytes = byteCount(from);
  const Region source = a.region(from, bytes, cpu::Access::Read);
  const Region place = a.region(target, bytes, cpu::Access::Write);
  if (target.type != from.type || byteCount(target) < bytes || !source || !place) return a.fail();
  std::memmove(place.data, source.data, bytes);
}

bool sameType(const Value& a, const Value& b, const Value& c) {
  return a.valid && b.valid && c.valid && a.where.type == b.where.type &&
         a.where.type == c.where.type;
}

template <bool Greatest, typename A>
void extreme(A& a) {
  const Value values[] = {get(a, a.any("IN1")), get(a, a.any("IN2")), get(a, a.any("IN3"))};
  if (!sameType(values[0], values[1], values[2])) return a.fail();
  const Value* best = &values[0];
  for (const Value& value : values)
    if (Greatest ? value.number > best->number : value.number < best->number) best = &value;
  put(a, best->where);
}

// A BOOL behind an ANY is one bit.
bool copyBit(Arguments& a, const AnyPointer& from, const AnyPointer& to) {
  if (from.type != TypeCode::Bool || to.type != TypeCode::Bool || from.count != 1) return false;
  const auto byteOf = [](AnyPointer p) { return p.pointer &= ~7u, p; };
  const Region source = a.region(byteOf(from), 1, cpu::Access::Read);
  const Region place = a.region(byteOf(to), 1, cpu::Access::Write);
  if (!source || !place) return false;
  const bool bit = *source.data >> (from.pointer & 7) & 1;
  const auto mask = static_cast<std::uint8_t>(1u << (to.pointer & 7));
  *place.data = static_cast<std::uint8_t>(bit ? *place.data | mask : *place.data & ~mask);
  return true;
}

}  // namespace

void limitValue(Fc<22>& a) {
  const Value low = get(a, a.any("MN")), in = get(a, a.any("IN")), high = get(a, a.any("MX"));
  if (!sameType(low, in, high) || low.number > high.number) return a.fail();
  put(a, in.number < low.number ? low.where : in.number > high.number ? high.where : in.where);
}

void selectValue(Fc<36>& a) {
  const AnyPointer zero = a.any("IN0"), one = a.any("IN1");
  if (zero.type != one.type) return a.fail();
  const AnyPointer& chosen = a.flag("G") ? one : zero;
  if (!copyBit(a, chosen, a.any("RET_VAL"))) put(a, chosen);
}

void greatestValue(Fc<25>& a) { extreme<true>(a); }
void smallestValue(Fc<27>& a) { extreme<false>(a); }

}  // namespace merker::system
