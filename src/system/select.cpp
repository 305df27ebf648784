// FC 22 LIMIT, 25 MAX, 27 MIN, 36 SEL (S7-IEC-08): parameters of type ANY that must have the same
// type.
#include <bit>
#include <cmath>
#include <cstring>

#include "base/bytes.h"
#include "system/arguments.h"

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

Value get(Arguments& a, std::size_t i) {
  Value value{.where = a.any(i)};
  const TypeCode type = value.where.type;
  if (!isNumber(type)) return value;
  const Region bytes = a.region(value.where, type == TypeCode::Int ? 2 : 4, cpu::Access::Read);
  if (!bytes) return value;
  value.number = number(type, bytes.data);
  value.valid = !std::isnan(value.number);
  return value;
}

// Copies what `from` names to RET_VAL (parameter `to`), which must have the same type.
void put(Arguments& a, const AnyPointer& from, std::size_t to) {
  const AnyPointer target = a.any(to);
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

template <bool Greatest>
void extreme(Arguments& a) {
  const Value values[] = {get(a, 0), get(a, 1), get(a, 2)};
  if (!sameType(values[0], values[1], values[2])) return a.fail();
  const Value* best = &values[0];
  for (const Value& value : values)
    if (Greatest ? value.number > best->number : value.number < best->number) best = &value;
  put(a, best->where, 3);
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

void limitValue(Arguments& a) {
  const Value low = get(a, 0), in = get(a, 1), high = get(a, 2);
  if (!sameType(low, in, high) || low.number > high.number) return a.fail();
  put(a, in.number < low.number ? low.where : in.number > high.number ? high.where : in.where, 3);
}

void selectValue(Arguments& a) {
  const AnyPointer zero = a.any(1), one = a.any(2);
  if (zero.type != one.type) return a.fail();
  const AnyPointer& chosen = a.flag(0) ? one : zero;
  if (!copyBit(a, chosen, a.any(3))) put(a, chosen, 3);
}

void greatestValue(Arguments& a) { extreme<true>(a); }
void smallestValue(Arguments& a) { extreme<false>(a); }

}  // namespace merker::system
