#include "mc5/field.h"

#include <array>

namespace merker::mc5 {
namespace {

struct FormatCode {
  Format format;
  std::uint8_t code;
};
constexpr std::array kFormatCodes{
    FormatCode{Format::Counter, 0x01}, FormatCode{Format::Time, 0x02},
    FormatCode{Format::Fixed, 0x04},   FormatCode{Format::Characters, 0x10},
    FormatCode{Format::Bytes, 0x20},   FormatCode{Format::Hex, 0x40},
    FormatCode{Format::Binary, 0x80}};

// Distances are signed bytes.
std::uint32_t signExtended(std::uint32_t number) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(static_cast<std::int8_t>(number)));
}

}  // namespace

std::optional<Format> formatOf(std::uint8_t code) {
  for (const FormatCode& row : kFormatCodes)
    if (row.code == code) return row.format;
  return std::nullopt;
}

bool decodeField(char letter, std::uint32_t number, Operand& operand) {
  switch (letter) {
    case 'a':
      operand.area = number == 0 ? Area::Input : Area::Output;
      return true;
    case 'b':
      operand.bit = static_cast<std::uint8_t>(number);
      return true;
    case 'f':
      operand.bit = static_cast<std::uint8_t>(number);
      return !formatOf(operand.bit).has_value();
    case 'd':
      operand.value = signExtended(number);
      return true;
    default:
      operand.value = number;
      return true;
  }
}

std::optional<std::uint32_t> encodeField(char letter, const Operand& operand) {
  switch (letter) {
    case 'a':
      return operand.area == Area::Output ? 1 : 0;
    case 'b':
    case 'f':
      return operand.bit;
    case 'd':
      return operand.value & 0xFF;
    default:
      return operand.value;
  }
}

}  // namespace merker::mc5
