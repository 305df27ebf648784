// SFC 20 BLKMOV, 21 FILL, 81 UBLKMOV (S7-SFC-08, -09).
#include <algorithm>
#include <cstring>

#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::size_t kSource = 0, kDestination = 1;

struct Pair {
  Region source, destination;
  bool ready = false;
};

// W#16#8x01: no ANY at all; W#16#8x22 and 8x23: bits that are no whole bytes (S7-SFC-01).
bool wellFormed(Arguments& a, std::size_t i, const AnyPointer& any, cpu::ErrorCode length) {
  constexpr std::uint32_t kSyntax = 0x01;
  const bool bytes = any.type != TypeCode::Bool || any.count % 8 == 0;
  if (any.syntax == AnyPointer{}.syntax && bytes) return true;
  a.parameterError(i, bytes ? kSyntax : static_cast<std::uint32_t>(length));
  return false;
}

Pair regions(Arguments& a, std::uint32_t sourceBytes, const AnyPointer& source,
             std::uint32_t destinationBytes, const AnyPointer& destination) {
  if (!wellFormed(a, kSource, source, cpu::ErrorCode::LengthRead) ||
      !wellFormed(a, kDestination, destination, cpu::ErrorCode::LengthWrite))
    return {};
  Pair pair{a.region(source, sourceBytes, cpu::Access::Read), {}};
  if (!pair.source) {
    a.parameterError(kSource, pair.source.error);
    return pair;
  }
  pair.destination = a.region(destination, destinationBytes, cpu::Access::Write);
  if (!pair.destination) {
    a.parameterError(kDestination, pair.destination.error);
    return pair;
  }
  pair.ready = true;
  return pair;
}

}  // namespace

// As many bytes as both have.
void moveBlock(Arguments& a) {
  const AnyPointer source = a.any(kSource), destination = a.any(kDestination);
  const std::uint32_t bytes = std::min(byteCount(source), byteCount(destination));
  const Pair pair = regions(a, bytes, source, bytes, destination);
  if (!pair.ready) return;
  std::memmove(pair.destination.data, pair.source.data, bytes);
  a.status(0);
}

// 512 bytes at most, because nothing interrupts it.
void moveBlockUninterrupted(Arguments& a) {
  constexpr std::uint32_t kLongest = 512, kTooLong = 0x8091;
  const std::uint32_t bytes = std::min(byteCount(a.any(kSource)), byteCount(a.any(kDestination)));
  if (bytes > kLongest) return a.status(kTooLong);
  moveBlock(a);
}

// The pattern again and again; the last copy is cut off.
void fillBlock(Arguments& a) {
  const AnyPointer source = a.any(kSource), destination = a.any(kDestination);
  const std::uint32_t length = byteCount(source), bytes = byteCount(destination);
  const Pair pair = regions(a, length, source, bytes, destination);
  if (!pair.ready) return;
  const std::vector<std::uint8_t> pattern(pair.source.data, pair.source.data + length);
  for (std::uint32_t i = 0; i < bytes && length != 0; ++i)
    pair.destination.data[i] = pattern[i % length];
  a.status(0);
}

}  // namespace merker::system
