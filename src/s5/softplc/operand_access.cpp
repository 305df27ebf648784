#include "softplc/operand_access.h"

namespace merker::sinumerik {
namespace {

using mc5::Area;
using mc5::Operand;
using mc5::Width;

std::uint8_t* bytesOf(Machine& m, Area area) {
  switch (area) {
    case Area::Input:
      return m.inputs.data();
    case Area::Output:
      return m.outputs.data();
    default:
      return m.flags.data();
  }
}

unsigned byteCount(Width width) {
  return width == Width::Double ? 4 : width == Width::Word ? 2 : 1;
}

std::uint16_t dataWord(const Machine& m, std::uint32_t word) {
  const OpenData& open = m.levels.back().frames.back().data;
  const auto& memory = m.blocks.data();
  const std::uint64_t at = std::uint64_t{open.start} + word;
  return open.open && at < memory.size() ? memory[at] : std::uint16_t{0};
}

std::uint32_t readData(const Machine& m, const Operand& operand) {
  const std::uint16_t word = dataWord(m, operand.value);
  switch (operand.width) {
    case Width::Bit:
      return word >> operand.bit & 1;
    case Width::Left:
      return word >> 8;
    case Width::Right:
      return word & 0xFF;
    case Width::Double:
      return std::uint32_t{word} << 16 | dataWord(m, operand.value + 1);
    default:
      return word;
  }
}

std::uint16_t changed(std::uint16_t word, const Operand& operand, std::uint32_t value) {
  switch (operand.width) {
    case Width::Bit: {
      const auto mask = static_cast<std::uint16_t>(1u << operand.bit);
      return static_cast<std::uint16_t>(value != 0 ? word | mask : word & ~mask);
    }
    case Width::Left:
      return static_cast<std::uint16_t>((value & 0xFF) << 8 | (word & 0xFF));
    case Width::Right:
      return static_cast<std::uint16_t>((word & 0xFF00) | (value & 0xFF));
    default:
      return static_cast<std::uint16_t>(value);
  }
}

bool writeData(Machine& m, const Operand& operand, std::uint32_t value) {
  const OpenData& open = m.frame().data;
  const std::uint32_t words = operand.width == Width::Double ? 2 : 1;
  if (!open.open || operand.value + words > open.length) return false;
  std::uint16_t* word = &m.blocks.data()[open.start + operand.value];
  if (operand.width == Width::Double) *word++ = static_cast<std::uint16_t>(value >> 16);
  *word = changed(*word, operand, value);
  return true;
}

}  // namespace

std::uint32_t read(Machine& m, const Operand& operand) {
  if (operand.area == Area::Data) return readData(m, operand);
  const std::uint8_t* bytes = bytesOf(m, operand.area) + operand.value;
  if (operand.width == Width::Bit) return *bytes >> operand.bit & 1;
  std::uint32_t value = 0;
  for (unsigned i = 0; i < byteCount(operand.width); ++i) value = value << 8 | bytes[i];
  return value;
}

bool write(Machine& m, const Operand& operand, std::uint32_t value) {
  if (operand.area == Area::Data) return writeData(m, operand, value);
  std::uint8_t* bytes = bytesOf(m, operand.area) + operand.value;
  if (operand.width == Width::Bit) {
    const auto mask = static_cast<std::uint8_t>(1u << operand.bit);
    *bytes = static_cast<std::uint8_t>(value != 0 ? *bytes | mask : *bytes & ~mask);
    return true;
  }
  for (unsigned i = byteCount(operand.width); i-- > 0; value >>= 8)
    bytes[i] = static_cast<std::uint8_t>(value);
  return true;
}

}  // namespace merker::sinumerik
