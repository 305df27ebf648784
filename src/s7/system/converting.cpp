// FC 93 SEG, 94 ATH, 95 HTA, 96 ENCO, 97 DECO, 98 BCDCPL, 99 BITSUM of the TI-S7 converting blocks
// (S7-IEC-10).
#include <bit>

#include "base/bytes.h"
#include "system/call.h"

namespace merker::system {
namespace {

// Segments a (bit 0) to g (bit 6) of the digits 0 to F.
constexpr std::uint8_t kSegments[] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07,
                                      0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};

// The value of a hexadecimal digit; above 15: none.
std::uint8_t digit(std::uint8_t c) {
  if (c >= '0' && c <= '9') return static_cast<std::uint8_t>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<std::uint8_t>(c - 'A' + 10);
  return 0xFF;
}

struct Fields {
  Region from, to;
  bool ready = false;
};

// The bytes behind the two POINTERs.
template <typename A>
Fields fields(A& a, std::uint32_t from, std::uint32_t to) {
  const Fields result{a.region(a.pointer("IN"), from, cpu::Access::Read),
                      a.region(a.pointer("OUT"), to, cpu::Access::Write), true};
  if (!result.from) return a.parameterError("IN", result.from.error), Fields{};
  if (!result.to) return a.parameterError("OUT", result.to.error), Fields{};
  return result;
}

}  // namespace

// Four digits of a word into four bytes.
void sevenSegments(Fc<93>& a) {
  const std::uint32_t in = a.value("IN");
  std::uint32_t out = 0;
  for (unsigned i = 0; i < 4; ++i) out |= std::uint32_t{kSegments[in >> (4 * i) & 15]} << (8 * i);
  a.set("OUT", out);
}

// N characters into N / 2 bytes; an odd last digit is followed by 0.
void asciiToHex(Fc<94>& a) {
  constexpr std::uint32_t kNoDigit = 7;
  const auto count = static_cast<std::uint32_t>(a.value("N"));
  const Fields f = fields(a, count, (count + 1) / 2);
  if (!f.ready) return;
  bool good = true;
  for (std::uint32_t i = 0; i < count; i += 2) {
    const std::uint8_t high = digit(f.from.data[i]);
    const std::uint8_t low = i + 1 < count ? digit(f.from.data[i + 1]) : std::uint8_t{0};
    good = good && high < 16 && low < 16;
    f.to.data[i / 2] =
        static_cast<std::uint8_t>((high & 15) * (high < 16) << 4 | (low & 15) * (low < 16));
  }
  a.status(good ? 0 : kNoDigit);
  if (!good) a.fail();
}

// N bytes into 2 · N characters.
void hexToAscii(Fc<95>& a) {
  const auto count = static_cast<std::uint32_t>(a.value("N"));
  const Fields f = fields(a, count, 2 * count);
  if (!f.ready) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    f.to.data[2 * i] = static_cast<std::uint8_t>("0123456789ABCDEF"[f.from.data[i] >> 4]);
    f.to.data[2 * i + 1] = static_cast<std::uint8_t>("0123456789ABCDEF"[f.from.data[i] & 15]);
  }
  a.status(0);
}

// The number of the lowest bit that is 1; without any 0 and BIE 0.
void encodeBit(Fc<96>& a) {
  const std::uint32_t in = a.value("IN");
  if (in == 0) a.fail();
  a.set("RET_VAL", in == 0 ? 0u : static_cast<std::uint32_t>(std::countr_zero(in)));
}

void decodeBit(Fc<97>& a) { a.set("RET_VAL", 1u << (a.value("IN") & 31)); }

// 10^7 minus seven digits.
void tensComplement(Fc<98>& a) {
  std::uint32_t in = a.value("IN"), number = 0, scale = 1, out = 0;
  for (unsigned i = 0; i < 7; ++i, in >>= 4, scale *= 10) number += (in & 15) * scale;
  number = (scale - number % scale) % scale;
  for (unsigned i = 0; i < 7; ++i, number /= 10) out |= number % 10 << (4 * i);
  a.set("RET_VAL", out);
}

void countBits(Fc<99>& a) {
  a.set("RET_VAL", static_cast<std::uint32_t>(std::popcount(a.value("IN"))));
}

}  // namespace merker::system
