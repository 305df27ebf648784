// SFC 79 SET, 80 RSET: a range of output bits (S7-SFC-24).
#include "cpu/cpu.h"
#include "system/call.h"

namespace merker::system {
namespace {

// Outputs change in the image and at the terminals, whichever of both the pointer names.
cpu::SyncError writeBit(cpu::Machine& m, Area area, BitAddress address, bool value) {
  if (area != Area::Output && area != Area::Peripheral)
    return cpu::write(m, area, Width::Bit, address, value);
  const std::uint32_t byte = address / 8;
  if (!m.areas.answers(m.areas.outputPresent, byte, 1))
    return {.code = cpu::ErrorCode::PeripheralWrite, .area = Area::Peripheral, .detail = byte};
  const auto mask = static_cast<std::uint8_t>(1u << (address & 7));
  std::uint8_t& terminal = m.areas.outputs[byte];
  terminal = static_cast<std::uint8_t>(value ? terminal | mask : terminal & ~mask);
  m.cpu->modules().written(byte, 1);
  return byte < m.areas.imageBytes ? cpu::write(m, Area::Output, Width::Bit, address, value)
                                   : cpu::SyncError{};
}

// N bits from SA on.
template <typename A>
void writeRange(A& a, bool value) {
  const std::int32_t count = a.integer("N");
  const AnyPointer start = a.pointer("SA");
  Area area = pointerArea(start.pointer);
  if (area == Area::CallerLocal) area = Area::Local;
  for (std::int32_t i = 0; i < count; ++i) {
    const BitAddress address = (start.pointer & 0xFFFFFF) + static_cast<std::uint32_t>(i);
    if (const auto error = writeBit(a.machine(), area, address, value))
      return a.parameterError("SA", error.code);
  }
  a.status(0);
}

}  // namespace

void setBits(Sfc<79>& a) { writeRange(a, true); }
void resetBits(Sfc<80>& a) { writeRange(a, false); }

}  // namespace merker::system
