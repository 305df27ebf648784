// SFC 20 BLKMOV, 21 FILL, 81 UBLKMOV (S7-SFC-08, -09).
#include <algorithm>
#include <cstring>

#include "system/call.h"

namespace merker::system {
namespace {

struct Field {
  std::size_t parameter;
  AnyPointer where;
  std::uint32_t bytes;
};

struct Pair {
  Region source, destination;
  bool ready = false;
};

// W#16#8x01: no ANY at all; W#16#8x22 and 8x23: bits that are no whole bytes (S7-SFC-01).
bool wellFormed(Arguments& a, const Field& field, cpu::ErrorCode length) {
  const AnyPointer& any = field.where;
  constexpr std::uint32_t kSyntax = 0x01;
  const bool bytes = any.type != TypeCode::Bool || any.count % 8 == 0;
  if (any.syntax == AnyPointer{}.syntax && bytes) return true;
  a.parameterError(field.parameter, bytes ? kSyntax : static_cast<std::uint32_t>(length));
  return false;
}

Pair regions(Arguments& a, const Field& source, const Field& destination) {
  if (!wellFormed(a, source, cpu::ErrorCode::LengthRead) ||
      !wellFormed(a, destination, cpu::ErrorCode::LengthWrite))
    return {};
  Pair pair{a.region(source.where, source.bytes, cpu::Access::Read), {}};
  if (!pair.source) {
    a.parameterError(source.parameter, pair.source.error);
    return pair;
  }
  pair.destination = a.region(destination.where, destination.bytes, cpu::Access::Write);
  if (!pair.destination) {
    a.parameterError(destination.parameter, pair.destination.error);
    return pair;
  }
  pair.ready = true;
  return pair;
}

template <typename A>
Field field(A& a, NameIn<A> name) {
  const AnyPointer where = a.any(name);
  return {name.index, where, byteCount(where)};
}

// As many bytes as both have.
template <typename A>
void move(A& a) {
  Field source = field(a, "SRCBLK"), destination = field(a, "DSTBLK");
  source.bytes = destination.bytes = std::min(source.bytes, destination.bytes);
  const Pair pair = regions(a, source, destination);
  if (!pair.ready) return;
  std::memmove(pair.destination.data, pair.source.data, source.bytes);
  a.status(0);
}

}  // namespace

void moveBlock(Sfc<20>& a) { move(a); }

// 512 bytes at most, because nothing interrupts it.
void moveBlockUninterrupted(Sfc<81>& a) {
  constexpr std::uint32_t kLongest = 512, kTooLong = 0x8091;
  const std::uint32_t bytes = std::min(byteCount(a.any("SRCBLK")), byteCount(a.any("DSTBLK")));
  if (bytes > kLongest) return a.status(kTooLong);
  move(a);
}

// The pattern again and again; the last copy is cut off.
void fillBlock(Sfc<21>& a) {
  const Field source = field(a, "BVAL"), destination = field(a, "BLK");
  const std::uint32_t length = source.bytes;
  const Pair pair = regions(a, source, destination);
  if (!pair.ready) return;
  const std::vector<std::uint8_t> pattern(pair.source.data, pair.source.data + length);
  for (std::uint32_t i = 0; i < destination.bytes && length != 0; ++i)
    pair.destination.data[i] = pattern[i % length];
  a.status(0);
}

}  // namespace merker::system
