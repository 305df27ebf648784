#include "itcp/value_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "plc/cell_value.h"
#include "scenario/display.h"
#include "scenario/long_value.h"
#include "scenario/term.h"

namespace merker::itcp {
namespace {

using s7comm::Memory;
using s7comm::Range;

constexpr unsigned kBitsOfByte = 8;

std::string longText(const address::Reference& reference, const s7comm::Bytes& octets) {
  constexpr std::size_t kStringHead = 2;  // longest and present length (S7-TYPES-19)
  std::string content(octets.begin(), octets.end());
  if (reference.type == TypeCode::String && octets.size() >= kStringHead)
    content = content.substr(kStringHead, octets[1]);
  return simulator::plainLong(reference.type, content);
}

bool hasNotation(const address::Reference& reference) {
  constexpr TypeCode kTypes[] = {TypeCode::S5Time, TypeCode::Time, TypeCode::Date,
                                 TypeCode::TimeOfDay};
  return address::isTimer(reference.operand) || std::ranges::count(kTypes, reference.type) > 0;
}

std::string numberText(const address::Reference& reference, std::uint32_t bits) {
  const auto value = simulator::numericValue(reference, bits);
  if (const bool* const truth = std::get_if<bool>(&value)) return *truth ? "1" : "0";
  if (const double* const real = std::get_if<double>(&value))
    return fmt::format("{}", static_cast<float>(*real));
  return fmt::format("{}", std::get<std::int64_t>(value));
}

}  // namespace

std::optional<Range> rangeOf(const address::Reference& reference) {
  const address::Operand& operand = reference.operand;
  if (reference.nc != 0 || reference.partner) return std::nullopt;
  if (controller::isCell(reference))
    return Range{.memory = address::isTimer(operand) ? Memory::Timer : Memory::Counter,
                 .begin = operand.value,
                 .octets = 2};
  const bool seen = operand.area >= Area::Peripheral && operand.area <= Area::DataBlock;
  if (!address::isMemory(operand) || !seen || reference.outputSide) return std::nullopt;
  return Range{.memory = static_cast<Memory>(operand.area),
               .block = static_cast<std::uint16_t>(std::max(reference.db, 0)),
               .begin = operand.value / kBitsOfByte,
               .octets = reference.bytes != 0 ? reference.bytes : byteCount(operand.width),
               .bit = static_cast<std::uint8_t>(operand.value % kBitsOfByte),
               .oneBit = reference.bytes == 0 && operand.width == Width::Bit};
}

std::string textOf(const address::Reference& reference, const s7comm::Bytes& octets) {
  if (simulator::isLong(reference)) return longText(reference, octets);
  std::uint32_t bits = 0;
  for (const std::uint8_t octet : octets) bits = bits << kBitsOfByte | octet;
  if (reference.type == TypeCode::Char)
    return toUtf8(std::string(1, static_cast<char>(bits)), Encoding::Cp1252);
  return hasNotation(reference) ? simulator::formatOperand(reference, bits)
                                : numberText(reference, bits);
}

}  // namespace merker::itcp
