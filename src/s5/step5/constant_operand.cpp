#include "step5/constant_operand.h"

#include <algorithm>

#include "mc5/constant.h"
#include "mc5/field.h"

namespace merker::step5 {
namespace {

using mc5::Format;
using mc5::OperandKind;

std::string formatWord(const Scanner& scanner) {
  return {upper(scanner.peek()), upper(scanner.peek(1))};
}

// "K#05 1234": the format byte in hexadecimal, for words that their format cannot show. The sign
// keeps K#B0 apart from KB 0.
bool isRaw(const Scanner& scanner) {
  return upper(scanner.peek()) == 'K' && scanner.peek(1) == '#' && isHexDigit(scanner.peek(2)) &&
         isHexDigit(scanner.peek(3)) && scanner.peek(4) == ' ';
}

bool belongs(Format format, char c) {
  switch (format) {
    case Format::Hex:
      return isHexDigit(c);
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
  const std::size_t start = scanner.mark();
  std::string text(scanner.take([&](char c) { return belongs(format, c); }));
  // A second comma is that of a list: AKKU1 = KY 1,2, VKE = 0.
  if (format == Format::Bytes && text.ends_with(',') && text.find(',') + 1 < text.size()) {
    text.pop_back();
    scanner.back(start + text.size());
    return text;
  }
  // KY 0, 160 and KM 00111110 01011011 may have a blank inside.
  const bool more = (format == Format::Bytes && text.ends_with(',')) ||
                    (format == Format::Binary && text.size() == 8);
  if (!more) return text;
  const std::size_t mark = scanner.mark();
  scanner.skipBlanks();
  const auto second = scanner.take([&](char c) { return c != ',' && belongs(format, c); });
  if (second.empty() || (format == Format::Binary && second.size() != 8))
    scanner.back(mark);
  else
    text += second;
  return text;
}

// 'AB': whatever stands between the quotes, also blanks and "!".
std::optional<std::string> quoted(Scanner& scanner) {
  scanner.skip();
  std::string text(scanner.take([](char c) { return c != '\''; }));
  return scanner.accept('\'') ? std::optional(text) : std::nullopt;
}

// AB: up to a blank or the mark of a comment; the second character may be such a mark ("A!").
std::string unquoted(Scanner& scanner) {
  const auto isMark = [](char c) { return c == '!' || c == ';'; };
  std::string text;
  while (!scanner.atEnd() && !isBlank(scanner.peek()) &&
         (text.size() == 1 || !isMark(scanner.peek()))) {
    text += scanner.peek();
    scanner.skip();
  }
  return text;
}

// The characters behind KC; KC alone is two blanks. Behind more than one blank unquoted text might
// be a character or a comment: it needs quotes.
std::optional<std::string> characters(Scanner& scanner, std::size_t blanks) {
  if (scanner.peek() == '\'') return quoted(scanner);
  const bool nothing = scanner.atEnd() || scanner.peek() == '!' || scanner.peek() == ';';
  if (blanks > 1 && !nothing) {
    unquoted(scanner);
    return std::nullopt;
  }
  return unquoted(scanner);
}

Operand rawConstant(Scanner& scanner) {
  Operand result;
  result.offset = scanner.offset();
  scanner.skip(2);
  const auto code =
      static_cast<std::uint8_t>(std::stoul(std::string(scanner.take(isHexDigit)), nullptr, 16));
  scanner.skipBlanks();
  const std::string digits(scanner.take(isHexDigit).substr(0, 4));
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
  const std::string digits(scanner.take(isHexDigit));
  if (digits.size() != 8) return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16));
}

std::optional<std::uint32_t> value(Scanner& scanner, Format format, std::size_t blanks) {
  if (format == Format::Float && scanner.peek() == '#') return floatBits(scanner);
  if (format != Format::Characters) return mc5::constantBits(format, numberText(scanner, format));
  const auto text = characters(scanner, blanks);
  return text ? mc5::constantBits(format, *text) : std::nullopt;
}

}  // namespace

bool isConstant(const Scanner& scanner) {
  return isRaw(scanner) || mc5::findConstantFormat(formatWord(scanner)) != nullptr;
}

std::optional<Operand> parseConstant(Scanner& scanner, Failure& failure, bool equals) {
  if (isRaw(scanner)) return rawConstant(scanner);
  Operand result;
  result.offset = scanner.offset();
  const std::size_t start = scanner.mark();
  const mc5::ConstantFormat& row = *mc5::findConstantFormat(formatWord(scanner));
  scanner.skip(2);
  std::size_t blanks = scanner.skipBlanks();
  if (equals && scanner.accept('=')) blanks = scanner.skipBlanks();
  const auto bits = value(scanner, row.format, blanks);
  result.length = std::max<std::size_t>(scanner.since(start).size(), 2);
  result.value = {.kind = OperandKind::Constant, .format = row.format, .value = bits.value_or(0)};
  if (bits) return result;
  failure = {ProblemCode::P1108, result.offset, result.length, std::string(row.word),
             std::string(row.range)};
  return std::nullopt;
}

}  // namespace merker::step5
