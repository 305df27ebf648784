#include "itcp/quoted_printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace merker::itcp {
namespace {

constexpr std::size_t kLongestLine = 998;  // without CR LF, RFC 5322, 2.1.1
constexpr std::size_t kLongestEncodedLine = 75;
// A line of a header has 76 with the word (RFC 2047, 2); the first one has "Subject: ", too.
constexpr std::size_t kLongestWord = 66;
constexpr std::string_view kWordBegin = "=?UTF-8?Q?", kWordEnd = "?=";

constexpr bool isPrintable(char c) { return c >= ' ' && c <= '~'; }

std::string encoded(char c) { return fmt::format("={:02X}", static_cast<unsigned char>(c)); }

// A character of a line; a blank at its end would be lost on the way.
std::string inLine(char c, bool last) {
  const bool blank = c == ' ' || c == '\t';
  return (isPrintable(c) && c != '=' && !blank) || (blank && !last) ? std::string(1, c)
                                                                    : encoded(c);
}

// Letters and digits alone have no meaning in any header.
std::string inWord(char c) {
  const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  return c == ' ' ? "_" : plain ? std::string(1, c) : encoded(c);
}

void addLine(std::string& out, std::string_view line) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string piece = inLine(line[i], i + 1 == line.size());
    if (length + piece.size() > kLongestEncodedLine) {
      out += "=\r\n";
      length = 0;
    }
    out += piece;
    length += piece.size();
  }
}

template <typename Each>
void eachLine(std::string_view text, const Each& each) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find("\r\n", begin), text.size());
    each(text.substr(begin, end - begin), end == text.size());
    begin = end + 2;
  }
}

// The next character of a text, which may be several bytes.
std::string nextCharacter(std::string_view& text) {
  std::size_t bytes = 1;
  while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) ++bytes;
  std::string piece;
  for (const char c : text.substr(0, bytes)) piece += inWord(c);
  text.remove_prefix(bytes);
  return piece;
}

}  // namespace

bool isPlainText(std::string_view text) {
  bool plain = true;
  eachLine(text, [&](std::string_view line, bool) {
    plain = plain && line.size() <= kLongestLine && std::ranges::all_of(line, isPrintable);
  });
  return plain;
}

std::string quotedPrintable(std::string_view text) {
  std::string out;
  eachLine(text, [&](std::string_view line, bool last) {
    addLine(out, line);
    if (!last) out += "\r\n";
  });
  return out;
}

std::string encodedWords(std::string_view text) {
  if (std::ranges::all_of(text, isPrintable)) return std::string(text);
  std::string out, word(kWordBegin);
  while (!text.empty()) {
    const std::string piece = nextCharacter(text);
    if (word.size() + piece.size() + kWordEnd.size() > kLongestWord) {
      out += word + std::string(kWordEnd) + "\r\n ";
      word = kWordBegin;
    }
    word += piece;
  }
  return out + word + std::string(kWordEnd);
}

}  // namespace merker::itcp
