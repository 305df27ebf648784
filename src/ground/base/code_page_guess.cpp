// Which code page a text is in, by its content.
#include <algorithm>
#include <cstdint>

#include "base/code_page.h"
#include "base/text.h"

namespace merker {
namespace {

bool isHigh(char c) { return static_cast<std::uint8_t>(c) >= 0x80; }

bool isOneOf(char c, std::string_view list) { return list.find(c) != std::string_view::npos; }

bool consistsOf(std::string_view text, std::string_view list) {
  return std::ranges::all_of(text, [&](char c) { return !isHigh(c) || isOneOf(c, list); });
}

// Letters of 1251; those of 1252 stand here one by one among others of ASCII.
bool isCyrillic(char c) { return static_cast<std::uint8_t>(c) >= 0xC0 || isOneOf(c, "\xA8\xB8"); }

// Two bytes of GB 2312: 16 to 87 are rows of characters, 1 to 9 signs.
bool isPair(char lead, char trail) {
  const auto a = static_cast<std::uint8_t>(lead), b = static_cast<std::uint8_t>(trail);
  return ((a >= 0xB0 && a <= 0xF7) || (a >= 0xA1 && a <= 0xA9)) && b >= 0xA1 && b <= 0xFE;
}
// The rows of usual characters, and of signs.
bool isUsual(char lead) { return static_cast<std::uint8_t>(lead) <= 0xD7; }
// Half of the characters have such a byte; two letters of 1252 side by side (ÇÃO) have none.
bool isNoLetter(char c) { return static_cast<std::uint8_t>(c) < 0xC0; }

struct Runs {
  std::size_t bytes = 0, cyrillic = 0, pairs = 0, usualPairs = 0, foreignPairs = 0;

  void add(std::string_view run) {
    constexpr std::size_t kWord = 3;
    bytes += run.size();
    if (run.size() >= kWord && std::ranges::all_of(run, isCyrillic)) cyrillic += run.size();
    for (std::size_t i = 0; i + 1 < run.size() && isPair(run[i], run[i + 1]); i += 2) {
      ++pairs;
      usualPairs += isUsual(run[i]) ? 1 : 0;
      foreignPairs += isNoLetter(run[i]) || isNoLetter(run[i + 1]) ? 1 : 0;
    }
  }
  bool areChinese() const {
    return pairs * 4 > bytes && usualPairs * 2 > pairs && foreignPairs * 4 >= pairs;
  }
};

Runs runsOf(std::string_view text) {
  Runs runs;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    while (i < text.size() && isHigh(text[i])) ++i;
    if (i > begin)
      runs.add(text.substr(begin, i - begin));
    else
      ++i;
  }
  return runs;
}

// B3, B9 or BF, in 1252 signs, between two small letters; one of them may be m3h.
bool hasPolishLetters(std::string_view text) {
  const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
  std::size_t found = 0;
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    found += isOneOf(text[i], "\xB3\xB9\xBF") && isSmall(text[i - 1]) && isSmall(text[i + 1]);
  const bool others =
      std::ranges::any_of(text, [](char c) { return isOneOf(c, "\x9C\x9F\xE6\xEA\xF1\xF3"); });
  return found > 1 || (found == 1 && others);
}

// Letters of German and of the Nordic languages, which lists of them have side by side.
constexpr std::string_view kNorthern = "\xC4\xD6\xDC\xE4\xF6\xFC\xDF\xC5\xC6\xD8\xE5\xE6\xF8";
// Where 1254 has letters of Turkish and 1252 those of Icelandic; and all others of Turkish, with
// signs of both.
constexpr std::string_view kOnlyTurkish = "\xD0\xDD\xDE\xF0\xFD\xFE";
constexpr std::string_view kTurkish =
    "\xD0\xDD\xDE\xF0\xFD\xFE\xC7\xD6\xDC\xE7\xF6\xFC\xC2\xCE\xDB\xE2\xEE\xFB"
    "\x80\x85\x91\x92\x93\x94\x96\x97\xA0\xA7\xAB\xB0\xB1\xB2\xB3\xB4\xB5\xB7\xBB\xBD";

// UTF-16 without its mark: every other byte of ASCII text is 0.
std::optional<Encoding> unmarkedUtf16(std::string_view bytes) {
  std::size_t zeros[2] = {};
  for (std::size_t i = 0; i < bytes.size(); ++i) zeros[i % 2] += bytes[i] == '\0';
  const bool half = bytes.size() % 2 == 0 && (zeros[0] + zeros[1]) * 4 > bytes.size();
  if (!half || (zeros[0] > 0 && zeros[1] > 0)) return std::nullopt;
  return zeros[0] > 0 ? Encoding::Utf16Be : Encoding::Utf16Le;
}

}  // namespace

unsigned guessedPage(std::string_view bytes) {
  const Runs runs = runsOf(bytes);
  if (runs.bytes == 0 || consistsOf(bytes, kNorthern)) return 1252;
  if (runs.cyrillic * 2 > runs.bytes) return 1251;
  if (runs.areChinese()) return 936;
  const bool turkish = std::ranges::any_of(bytes, [](char c) { return isOneOf(c, kOnlyTurkish); });
  if (turkish && consistsOf(bytes, kTurkish)) return 1254;
  return hasPolishLetters(bytes) ? 1250 : 1252;
}

unsigned contentPage(std::string_view bytes) {
  switch (detectEncoding(bytes)) {
    case Encoding::Cp1252:
      return guessedPage(bytes);
    case Encoding::Cp850:
      return 850;
    case Encoding::Cp437:
      return 437;
    case Encoding::Utf8:
    case Encoding::Utf16Le:
    case Encoding::Utf16Be:
    case Encoding::Binary:
      break;
  }
  return 0;
}

std::optional<std::string> decoded(std::string_view bytes, unsigned page) {
  const Encoding encoding = detectEncoding(bytes);
  if (encoding == Encoding::Binary) {
    const auto utf16 = unmarkedUtf16(bytes);
    return utf16 ? std::optional(toUtf8(bytes, *utf16)) : std::nullopt;
  }
  const unsigned found = contentPage(bytes);
  const unsigned chosen = found != 0 && page != 0 ? page : found;
  if (chosen == 0 || chosen == 850 || chosen == 437)
    return toUtf8(bytes, chosen == 0     ? encoding
                         : chosen == 850 ? Encoding::Cp850
                                         : Encoding::Cp437);
  return chosen == 1252 ? toUtf8(bytes, Encoding::Cp1252) : CodePage(chosen).toUtf8(bytes);
}

}  // namespace merker
