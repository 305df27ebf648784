#include "softplc/control_bits.h"

namespace merker::sinumerik {
namespace {

constexpr ControlBitRow kControlBitsRows[] = {
#define CONTROL_BIT(id, name, byte, bit, meaning) {ControlBit::id, name, byte, bit, meaning},
#include "softplc/control_bits.inc"
#undef CONTROL_BIT
};

}  // namespace

std::span<const ControlBitRow> controlBitRows() { return kControlBitsRows; }

std::uint8_t ControlBits::row(unsigned byte) const {
  unsigned value = 0;
  for (const ControlBitRow& r : kControlBitsRows)
    if (r.byte == byte && test(r.id)) value |= 1u << r.bit;
  return static_cast<std::uint8_t>(value);
}

}  // namespace merker::sinumerik
