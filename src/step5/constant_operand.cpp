#include "step5/constant_operand.h"

#include <algorithm>

#include "mc5/constant.h"
#include "mc5/field.h"

namespace merker::step5 {
namespace {

using mc5::Format;
using mc5::OperandKind;

bool isHex(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

std::string formatWord(const Scanner& scanner) {
  return {upper(scanner.peek()), upper(scanner.peek(1))};
}

// "K05 1234": the format byte in hexadecimal, for words that their format cannot show.
bool isRaw(const Scanner& scanner) {
  return upper(scanner.peek()) == 'K' && isHex(scanner.peek(1)) && isHex(scanner.peek(2)) &&
         scanner.peek(3) == ' ' && !mc5::findConstantFormat(formatWord(scanner));
}

bool belongs(Format format, char c) {
  switch (format) {
    case Format::Hex:
      return isHex(c);
    case Format::Binary:
      return isDigit(c);
    case Format::Time:
      return isDigit(c) || c == '.';
    case Format::Float:
      return isDigit(c) || c == '+' || c == '-';
    case Format::Bytes:
      return isDigit(c) || c == ',';
    default:
      return isDigit(c) || c == '+' || c == '-';
  }
}

std::string numberText(Scanner& scanner, Format format) {
  std::string text(scanner.take([&](char c) { return belongs(format, c); }));
  // KY 0, 160 and KM 00111110 01011011 may have a blank inside.
  const bool more = (format == Format::Bytes && text.ends_with(',')) ||
                    (format == Format::Binary && text.size() == 8);
  if (!more) return text;
  const std::size_t mark = scanner.mark();
  scanner.skipBlanks();
  const auto second = scanner.take([&](char c) { return belongs(format, c); });
  if (second.empty() || (format == Format::Binary && second.size() != 8))
    scanner.back(mark);
  else
    text += second;
  return text;
}

// Two characters; what follows them is a comment. KC alone is two blanks.
std::string characters(Scanner& scanner) {
  std::string text;
  while (text.size() < 2 && !scanner.atEnd() && !isBlank(scanner.peek()) && scanner.peek() != '!' &&
         scanner.peek() != ';') {
    text += scanner.peek();
    scanner.skip();
  }
  return text;
}

Operand rawConstant(Scanner& scanner) {
  Operand result;
  result.offset = scanner.offset();
  scanner.skip();
  const auto code =
      static_cast<std::uint8_t>(std::stoul(std::string(scanner.take(isHex)), nullptr, 16));
  scanner.skipBlanks();
  const std::string digits(scanner.take(isHex).substr(0, 4));
  const auto value =
      digits.empty() ? 0u : static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16));
  const auto format = mc5::formatOf(code);
  result.value = {.kind = OperandKind::Constant,
                  .format = format.value_or(Format::Other),
                  .bit = format ? std::uint8_t{0} : code,
                  .value = value};
  return result;
}

// KG #80000000: bits that seven decimal digits cannot tell.
std::optional<std::uint32_t> floatBits(Scanner& scanner) {
  if (!scanner.accept('#')) return std::nullopt;
  const std::string digits(scanner.take(isHex));
  if (digits.size() != 8) return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16));
}

}  // namespace

bool isConstant(const Scanner& scanner) {
  return isRaw(scanner) || mc5::findConstantFormat(formatWord(scanner)) != nullptr;
}

std::optional<Operand> parseConstant(Scanner& scanner, Failure& failure) {
  if (isRaw(scanner)) return rawConstant(scanner);
  Operand result;
  result.offset = scanner.offset();
  const std::size_t start = scanner.mark();
  const mc5::ConstantFormat& row = *mc5::findConstantFormat(formatWord(scanner));
  scanner.skip(2);
  const std::size_t blanks = scanner.skipBlanks();
  const bool empty = row.format == Format::Characters && blanks != 1 && blanks != 0;
  std::optional<std::uint32_t> bits;
  std::string text;
  if (row.format == Format::Float && scanner.peek() == '#') {
    bits = floatBits(scanner);
  } else {
    text = row.format == Format::Characters ? (empty ? std::string() : characters(scanner))
                                            : numberText(scanner, row.format);
    bits = mc5::constantBits(row.format, text);
  }
  result.length = std::max<std::size_t>(scanner.since(start).size(), 2);
  result.value = {.kind = OperandKind::Constant, .format = row.format, .value = bits.value_or(0)};
  if (bits) return result;
  failure = {ProblemCode::P1108, result.offset, result.length, std::string(row.word),
             std::string(row.range)};
  return std::nullopt;
}

}  // namespace merker::step5
