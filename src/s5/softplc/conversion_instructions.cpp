// Complements, BCD, floating point conversions, TAK (9.4.9, 9.4.14).
#include <cmath>

#include "base/bcd.h"
#include "mc5/s5_float.h"
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::Operation;

bool complement(Processor& p, const Instruction&) {
  p.registers().setLow1(static_cast<std::uint16_t>(~p.registers().low1()));
  return true;
}

void sign(Processor& p, std::int32_t value, bool overflow) {
  p.displays().setAnz(value > 0, value < 0);
  p.displays().overflow(overflow);
}

bool negateW(Processor& p, const Instruction&) {
  const auto result = static_cast<std::uint16_t>(0u - p.registers().low1());
  p.registers().setLow1(result);
  sign(p, static_cast<std::int16_t>(result), result == 0x8000);
  return true;
}

bool negateD(Processor& p, const Instruction&) {
  const std::uint32_t result = 0u - p.registers().akku1;
  p.registers().akku1 = result;
  sign(p, static_cast<std::int32_t>(result), result == 0x80000000);
  return true;
}

// The number in `digits` digits with the sign nibble 0 or F above them (S5-NUM-06).
std::optional<std::int32_t> signedBcd(std::uint32_t bits, int digits) {
  const std::uint32_t nibble = bits >> (4 * digits) & 0xF;
  const auto value = fromBcd(bits, digits);
  if (!value || (nibble != 0 && nibble != 0xF)) return std::nullopt;
  return nibble == 0 ? static_cast<std::int32_t>(*value) : -static_cast<std::int32_t>(*value);
}

std::optional<std::uint32_t> toSignedBcd(std::int32_t value, int digits, std::int32_t highest) {
  if (value < -highest || value > highest) return std::nullopt;
  const auto magnitude = static_cast<std::uint32_t>(value < 0 ? -value : value);
  return toBcd(magnitude, digits) | (value < 0 ? 0xFu << (4 * digits) : 0);
}

// What cannot be converted leaves the accumulator and sets OV and OS (OP-40).
template <typename Result>
bool converted(Processor& p, const std::optional<Result>& result, bool word) {
  p.displays().overflow(!result.has_value());
  if (!result) return true;
  if (word)
    p.registers().setLow1(static_cast<std::uint16_t>(*result));
  else
    p.registers().akku1 = static_cast<std::uint32_t>(*result);
  return true;
}

bool bcdToFixed(Processor& p, const Instruction&) {
  return converted(p, signedBcd(p.registers().low1(), 3), true);
}
bool fixedToBcd(Processor& p, const Instruction&) {
  const auto value = static_cast<std::int16_t>(p.registers().low1());
  return converted(p, toSignedBcd(value, 3, 999), true);
}
bool bcdToDouble(Processor& p, const Instruction&) {
  return converted(p, signedBcd(p.registers().akku1, 7), false);
}
bool doubleToBcd(Processor& p, const Instruction&) {
  const auto value = static_cast<std::int32_t>(p.registers().akku1);
  return converted(p, toSignedBcd(value, 7, 9'999'999), false);
}

bool fixedToFloat(Processor& p, const Instruction&) {
  p.registers().akku1 = mc5::fromDouble(static_cast<std::int32_t>(p.registers().akku1)).bits;
  return true;
}

// The fraction is cut off (S5-CONV-05).
bool floatToFixed(Processor& p, const Instruction&) {
  const double value = std::trunc(mc5::toDouble(p.registers().akku1));
  std::optional<std::int32_t> result;
  if (value >= -2147483648.0 && value <= 2147483647.0) result = static_cast<std::int32_t>(value);
  return converted(p, result, false);
}

bool exchange(Processor& p, const Instruction&) {
  std::swap(p.registers().akku1, p.registers().akku2);
  return true;
}

constexpr HandlerRow kConversionRows[] = {{Operation::COMPLEMENT_W, complement},
                                          {Operation::NEGATE_W, negateW},
                                          {Operation::NEGATE_D, negateD},
                                          {Operation::BCD_TO_FIXED, bcdToFixed},
                                          {Operation::FIXED_TO_BCD, fixedToBcd},
                                          {Operation::BCD_TO_DOUBLE, bcdToDouble},
                                          {Operation::DOUBLE_TO_BCD, doubleToBcd},
                                          {Operation::FIXED_TO_FLOAT, fixedToFloat},
                                          {Operation::FLOAT_TO_FIXED, floatToFixed},
                                          {Operation::TAK, exchange}};

}  // namespace

HandlerRows conversionHandlers() { return kConversionRows; }

}  // namespace merker::sinumerik
