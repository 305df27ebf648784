#include "mc7/field.h"

namespace merker::mc7 {
namespace {

// Area nibble 0 is the periphery, 1..6 are E A M DB DI L (MC7 section 1).
Area areaOf(std::uint32_t nibble) {
  return static_cast<Area>(static_cast<std::uint32_t>(Area::Peripheral) + nibble);
}
std::uint32_t nibbleOf(Area area) {
  return static_cast<std::uint32_t>(area) - static_cast<std::uint32_t>(Area::Peripheral);
}

bool setArea(Area& area, std::uint32_t nibble, std::uint32_t lowest) {
  area = areaOf(nibble);
  return nibble >= lowest && nibble <= nibbleOf(Area::Local);
}

// Bits of a nibble that names a status bit (MC7 section 2.1): 0 1 2 4 5 6 8 A C E.
constexpr std::uint32_t kStatusBits = 0x5577;

bool setStatusBit(Operand& operand, std::uint32_t number) {
  operand.value = number;
  return (kStatusBits >> number & 1) != 0;
}

// Parameter i of an FC lies 2 * (i + 1) words behind the jump over the list (MC7 section 5).
bool setParameter(Operand& operand, std::uint32_t number) {
  operand.value = number / 2 - 1;
  return number >= 2 && number % 2 == 0;
}

constexpr std::uint32_t kLowestPointerArea = 3;  // M
constexpr std::uint32_t kHighestShift = 32;

}  // namespace

bool decodeField(char letter, std::uint32_t number, Operand& operand) {
  switch (letter) {
    case 'a':
      return setArea(operand.area, number, operand.width == Width::Bit ? 1 : 0);
    case 'm':
      return setArea(operand.area, number, kLowestPointerArea);
    case 'p':
      return setArea(operand.pointerArea, number, kLowestPointerArea);
    case 'q':
      operand.area = number == 0 ? Area::Input : Area::Output;
      return true;
    case 'r':
      operand.reg = static_cast<std::uint8_t>(number + 1);
      return true;
    case 'w':
      operand.value += number * 8;
      return true;
    case 'b':
      operand.value += number;
      return true;
    case 'd':
      operand.value = static_cast<std::uint32_t>(static_cast<std::int16_t>(number));
      return true;
    case 's':
      return setStatusBit(operand, number);
    case 'i':
      return setParameter(operand, number);
    case 'c':
      operand.value = number;
      return number <= kHighestShift;
    default:
      operand.value = number;
      return true;  // k n o
  }
}

std::optional<std::uint32_t> encodeField(char letter, const Operand& operand) {
  switch (letter) {
    case 'a':
    case 'm':
      return nibbleOf(operand.area);
    case 'p':
      return nibbleOf(operand.pointerArea);
    case 'q':
      if (operand.area != Area::Input && operand.area != Area::Output) return std::nullopt;
      return operand.area == Area::Output ? 1 : 0;
    case 'r':
      return static_cast<std::uint32_t>(operand.reg - 1);
    case 'w':
      return operand.value / 8;
    case 'b':
      return operand.value % 8;
    case 'd':
      return operand.value & 0xFFFF;
    case 'i':
      return operand.value < 0x7FFF ? std::optional{2 * (operand.value + 1)} : std::nullopt;
    default:
      return operand.value;  // c k n o s
  }
}

}  // namespace merker::mc7
