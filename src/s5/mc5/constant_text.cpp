// Constants as text: the notation of their format if it holds all bits, else format byte and
// hexadecimal number.
#include <fmt/format.h>

#include <cmath>

#include "mc5/constant.h"
#include "mc5/s5_float.h"

namespace merker::mc5 {
namespace {

std::string timeText(std::uint32_t bits) {
  return fmt::format("{:x}.{}", bits & 0xFFF, bits >> 12);
}

std::string charactersText(std::uint32_t bits) {
  std::string text{static_cast<char>(bits >> 8), static_cast<char>(bits & 0xFF)};
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

// Seven digits of the fraction and the decimal exponent.
std::string floatText(std::uint32_t bits) {
  const double value = toDouble(bits);
  if (value == 0) return "+0000000+00";
  const std::string scientific = fmt::format("{:+.6e}", value);  // +d.dddddde+xx
  const std::size_t e = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(e + 1)) + 1;
  return fmt::format("{}{}{}{:+03}", scientific[0], scientific[1], scientific.substr(3, e - 3),
                     exponent);
}

std::string inFormat(Format format, std::uint32_t bits) {
  switch (format) {
    case Format::Byte:
      return std::to_string(bits);
    case Format::Hex:
    case Format::Other:
      return fmt::format("{:04X}", bits);
    case Format::Counter:
      return fmt::format("{:x}", bits);
    case Format::Time:
      return timeText(bits);
    case Format::Fixed:
      return fmt::format("{:+}", static_cast<std::int16_t>(bits));
    case Format::Characters:
      return charactersText(bits);
    case Format::Bytes:
      return fmt::format("{},{}", bits >> 8, bits & 0xFF);
    case Format::Binary:
      return fmt::format("{:08b} {:08b}", bits >> 8, bits & 0xFF);
    case Format::Float:
      return floatText(bits);
    case Format::SignedByte:
      return fmt::format("{:+}", static_cast<std::int8_t>(bits));
  }
  return {};
}

bool printable(const Operand& constant, const std::string& text) {
  if (constant.format == Format::Characters)
    for (const char c : text)
      if (c <= ' ' || c >= 0x7F || std::string_view("!;'").find(c) != std::string_view::npos)
        return false;  // they begin a comment or a quotation
  return constantBits(constant.format, text) == constant.value;
}

}  // namespace

std::string constantText(const Operand& constant) {
  const Format format = constant.format;
  if (format == Format::Other) return fmt::format("K#{:02X} {:04X}", constant.bit, constant.value);
  const std::string text = inFormat(format, constant.value);
  if (printable(constant, text)) return fmt::format("{} {}", info(format).word, text);
  if (format == Format::Float) return fmt::format("KG #{:08X}", constant.value);
  return fmt::format("K#{:02X} {:04X}", info(format).formatByte, constant.value);
}

}  // namespace merker::mc5
