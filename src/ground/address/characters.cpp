// Characters between single quotation marks with the $ escapes of STEP 7.
#include <fmt/format.h>

#include "address/constant.h"
#include "base/code_page.h"
#include "base/text.h"
#include "base/utf8.h"

namespace merker {
namespace {

struct Escape {
  char letter;
  std::string_view bytes;
};
// $N, the line break, is two characters.
constexpr Escape kEscapes[] = {{'$', "$"},  {'\'', "'"}, {'L', "\n"}, {'N', "\r\n"},
                               {'P', "\f"}, {'R', "\r"}, {'T', "\t"}};

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

// The bytes of the escape that `text` begins with behind its $, which are taken away; false if
// there is none.
bool takeEscape(std::string_view& text, std::string& bytes) {
  if (text.size() >= 2 && hexDigit(text[0]) >= 0 && hexDigit(text[1]) >= 0) {
    bytes += static_cast<char>(hexDigit(text[0]) << 4 | hexDigit(text[1]));
    text.remove_prefix(2);
    return true;
  }
  for (const Escape& escape : kEscapes) {
    if (text.empty() || upper(text.substr(0, 1))[0] != escape.letter) continue;
    bytes += escape.bytes;
    text.remove_prefix(1);
    return true;
  }
  return false;
}

// One character that is no escape; false if no code page of Windows has it.
bool takeCharacter(std::string_view& text, std::string& bytes) {
  std::size_t length = 0;
  const char32_t character = nextCharacter(text, length);
  const std::string byte = toCp1252(text.substr(0, length));
  const bool foreign = byte == "?" && character != U'?';
  const auto others = foreign ? windowsBytes(text.substr(0, length)) : std::nullopt;
  if (foreign && !others) return false;
  bytes += foreign ? *others : byte;
  text.remove_prefix(length);
  return true;
}

bool isPrintable(unsigned char byte) {
  const bool assigned =
      byte != 0x81 && byte != 0x8D && byte != 0x8F && byte != 0x90 && byte != 0x9D;
  return byte >= 0x20 && byte != 0x7F && assigned;
}

}  // namespace

Result<std::string> parseCharacters(std::string_view quoted, const Position& at) {
  const auto wrong = [&](std::string_view reason) {
    return makeProblem(ProblemCode::P0209, at, quoted, reason);
  };
  std::string_view text = quoted;
  if (!text.starts_with('\'')) return wrong("characters must be in single quotation marks");
  text.remove_prefix(1);
  std::string bytes;
  while (!text.empty() && text[0] != '\'') {
    if (text[0] != '$') {
      if (!takeCharacter(text, bytes)) return wrong("no code page of Windows has this character");
      continue;
    }
    text.remove_prefix(1);
    if (!takeEscape(text, bytes))
      return wrong("$ must be followed by $, ', L, N, P, R, T or two hexadecimal digits");
  }
  if (text.empty()) return wrong("the closing quotation mark is missing");
  if (text.size() > 1) return wrong("write a quotation mark inside the text as $'");
  return bytes;
}

std::string formatCharacters(std::string_view cp1252) {
  std::string result = "'";
  for (const char c : cp1252) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '$' || c == '\'')
      result += {'$', c};
    else if (isPrintable(byte))
      result += toUtf8({&c, 1}, Encoding::Cp1252);
    else
      result += fmt::format("${:02X}", byte);
  }
  return result + "'";
}

}  // namespace merker
