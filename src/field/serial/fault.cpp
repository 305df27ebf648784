#include "serial/fault.h"

namespace merker::serial {
namespace {

// Bits of the frame that the fault inverts.
std::uint16_t inverted(const Frame& frame, std::uint16_t bits, const Fault& fault) {
  if (fault.kind == Fault::Kind::Flip) return fault.pattern;
  const unsigned firstStop = frame.bits() - frame.stopBits;
  if (fault.kind == Fault::Kind::Parity)
    return static_cast<std::uint16_t>(frame.parity == Parity::None ? 0U : 1U << (firstStop - 1U));
  if (fault.kind == Fault::Kind::Stop) return static_cast<std::uint16_t>(bits & 1U << firstStop);
  return 0;
}

}  // namespace

Emission plain(const Frame& frame, std::uint8_t value) {
  Emission result;
  result.character = encode(frame, value);
  return result;
}

Emission disturbed(const Frame& frame, std::uint8_t value, const Fault& fault) {
  Emission result = plain(frame, value);
  const std::uint16_t bits = *result.character;
  const std::uint16_t other = encode(frame, static_cast<std::uint8_t>(fault.pattern));
  result.character = static_cast<std::uint16_t>(bits ^ inverted(frame, bits, fault));
  result.delay = fault.delay;
  result.overrun = fault.kind == Fault::Kind::Overrun;
  if (fault.kind == Fault::Kind::Drop) result.character.reset();
  if (fault.kind == Fault::Kind::Duplicate) result.before = bits;
  if (fault.kind == Fault::Kind::Insert) result.before = other;
  if (fault.kind == Fault::Kind::Replace) result.character = other;
  return result;
}

}  // namespace merker::serial
