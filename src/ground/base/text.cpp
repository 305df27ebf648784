#include "base/text.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/code_pages.h"
#include "base/utf8.h"

namespace merker {
namespace {

using Counts = std::array<std::size_t, 256>;

Counts countBytes(std::string_view bytes) {
  Counts counts{};
  for (const char c : bytes) ++counts[static_cast<unsigned char>(c)];
  return counts;
}

std::size_t sum(const Counts& counts, std::string_view which) {
  std::size_t total = 0;
  for (const char c : which) total += counts[static_cast<unsigned char>(c)];
  return total;
}

std::size_t sumFrom(const Counts& counts, std::size_t first, std::size_t last) {
  std::size_t total = 0;
  for (std::size_t i = first; i <= last; ++i) total += counts[i];
  return total;
}

// NUL never stands in a text; more than one control character in sixteen bytes is no text either.
// Tab, line feed, vertical tab, form feed, carriage return and the Ctrl-Z that ends a DOS file do.
bool looksBinary(const Counts& counts, std::size_t size) {
  if (counts[0] > 0) return true;
  const std::size_t control =
      sumFrom(counts, 0x01, 0x1F) - sum(counts, "\t\n\v\f\r\x1A") + counts[0x7F];
  return control * 16 > size;
}

// Letters with accents that CP850 has where CP437 has mixed single and double frames or Greek
// letters.
bool looksCp437(const Counts& counts) {
  const auto letters = sum(counts, "\xB5\xB6\xB7\xB8\xC6\xC7\xD2\xD3\xD4\xE3\xE5\xE9\xEA\xF5");
  const auto frames = sum(counts, "\xB5\xB6\xB7\xB8\xC6\xC7\xD0\xD1\xD2\xD3\xD4\xD5\xD6\xD7\xD8") +
                      sum(counts, "\xE0\xE2\xE3\xE4\xE8\xEA");
  return frames > letters;
}

// Rows of C4h or CDh are the frames of a DOS text, for nobody writes three of these letters.
bool hasFrames(std::string_view bytes) {
  return bytes.find("\xC4\xC4\xC4") != std::string_view::npos ||
         bytes.find("\xCD\xCD\xCD") != std::string_view::npos;
}

Encoding codePage(std::string_view bytes, const Counts& counts) {
  const std::size_t high = sumFrom(counts, 0x80, 0xFF);
  const std::size_t dos = sum(counts, "\x81\x84\x8E\x94\x99\x9A\xE1");      // ü ä Ä ö Ö Ü ß
  const std::size_t windows = sum(counts, "\xC4\xD6\xDC\xE4\xF6\xFC\xDF");  // Ä Ö Ü ä ö ü ß
  // More than half: the pair of quotation marks 84h … 93h of CP1252 must not count as DOS text.
  const bool isDos = hasFrames(bytes) || (dos * 2 > high && windows <= dos);
  if (!isDos) return Encoding::Cp1252;
  return looksCp437(counts) ? Encoding::Cp437 : Encoding::Cp850;
}

std::string fromCodePage(std::string_view bytes, std::span<const char16_t> upperHalf) {
  std::string result;
  result.reserve(bytes.size() + bytes.size() / 16);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    const std::size_t index = byte - 0x80u;
    if (byte < 0x80)
      result += c;
    else
      appendCharacter(result, index < upperHalf.size() ? upperHalf[index] : byte);
  }
  return result;
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
  const auto unit = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(bytes[i]),
               b = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(bigEndian ? a << 8 | b : b << 8 | a);
  };
  const auto isHalf = [](char32_t c, char32_t from) { return c >= from && c < from + 0x400; };
  std::string result;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    char32_t c = unit(i);
    if (i == 0 && c == 0xFEFF) continue;
    if (isHalf(c, 0xD800) && i + 3 < bytes.size() && isHalf(unit(i + 2), 0xDC00)) {
      c = 0x10000 + ((c - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    }
    appendCharacter(result, isHalf(c, 0xD800) || isHalf(c, 0xDC00) ? kReplacement : c);
  }
  if (bytes.size() % 2 != 0) appendCharacter(result, kReplacement);
  return result;
}

std::string fromUtf8(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (isValidUtf8(bytes)) return std::string(bytes);
  std::string result;
  for (std::size_t i = 0; i < bytes.size();) appendCharacter(result, nextCharacter(bytes, i));
  return result;
}

// The CP1252 byte of a character; 0 if it has none (and for U+0000 itself).
unsigned char cp1252Byte(char32_t character) {
  if (character < 0x80 || (character >= 0xA0 && character <= 0xFF))
    return static_cast<unsigned char>(character);
  const auto* const found = std::find(kCp1252.begin(), kCp1252.end(), character);
  if (found == kCp1252.end() || character == kReplacement) return 0;
  return static_cast<unsigned char>(0x80 + (found - kCp1252.begin()));
}

char asciiUpper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

Encoding detectEncoding(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) return Encoding::Utf8;
  if (bytes.starts_with("\xFF\xFE")) return Encoding::Utf16Le;
  if (bytes.starts_with("\xFE\xFF")) return Encoding::Utf16Be;
  const Counts counts = countBytes(bytes);
  if (looksBinary(counts, bytes.size())) return Encoding::Binary;
  return isValidUtf8(bytes) ? Encoding::Utf8 : codePage(bytes, counts);
}

std::string toUtf8(std::string_view bytes, Encoding encoding) {
  switch (encoding) {
    case Encoding::Utf8:
      return fromUtf8(bytes);
    case Encoding::Cp1252:
      return fromCodePage(bytes, kCp1252);
    case Encoding::Cp850:
      return fromCodePage(bytes, kCp850);
    case Encoding::Cp437:
      return fromCodePage(bytes, kCp437);
    case Encoding::Utf16Le:
      return fromUtf16(bytes, false);
    case Encoding::Utf16Be:
      return fromUtf16(bytes, true);
    case Encoding::Binary:
      break;
  }
  return std::string(bytes);
}

std::string toCp1252(std::string_view utf8) {
  std::string result;
  result.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size();) {
    const char32_t character = nextCharacter(utf8, i);
    const unsigned char byte = cp1252Byte(character);
    result += byte == 0 && character != 0 ? '?' : static_cast<char>(byte);
  }
  return result;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = asciiUpper(c);
  return result;
}

bool equalsIgnoreCase(std::string_view a, std::string_view b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
           return asciiUpper(x) == asciiUpper(y);
         });
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

std::size_t characterCount(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

}  // namespace merker
