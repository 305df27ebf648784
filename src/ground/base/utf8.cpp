#include "base/utf8.h"

#include <cstdint>
#include <cstring>

namespace merker {
namespace {

// Length of a sequence by its first byte, 0 if none begins so; C0, C1 and F5.. would be overlong or
// too large.
unsigned sequenceLength(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2) return 0;
  if (first < 0xE0) return 2;
  if (first < 0xF0) return 3;
  return first < 0xF5 ? 4 : 0;
}

bool isCharacter(char32_t value, unsigned length) {
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  return value >= kLeast[length] && value <= 0x10FFFF && (value < 0xD800 || value > 0xDFFF);
}

// The character of `length` bytes at `position`; 0x110000 if they are no valid sequence.
char32_t decode(std::string_view text, std::size_t position, unsigned length) {
  constexpr char32_t kNone = 0x110000;
  if (length == 0 || text.size() - position < length) return kNone;
  const auto first = static_cast<unsigned char>(text[position]);
  char32_t value = length == 1 ? first : first & (0x7Fu >> length);
  for (unsigned i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[position + i]);
    if ((next & 0xC0) != 0x80) return kNone;
    value = value << 6 | (next & 0x3Fu);
  }
  return isCharacter(value, length) ? value : kNone;
}

}  // namespace

char32_t nextCharacter(std::string_view utf8, std::size_t& position) {
  const unsigned length = sequenceLength(static_cast<unsigned char>(utf8[position]));
  const char32_t value = decode(utf8, position, length);
  const bool valid = value <= 0x10FFFF;
  position += valid ? length : 1;
  return valid ? value : kReplacement;
}

void appendCharacter(std::string& utf8, char32_t character) {
  const auto tail = [&](int shift) {
    utf8 += static_cast<char>(0x80 | (character >> shift & 0x3F));
  };
  if (character < 0x80) {
    utf8 += static_cast<char>(character);
  } else if (character < 0x800) {
    utf8 += static_cast<char>(0xC0 | character >> 6);
    tail(0);
  } else if (character < 0x10000) {
    utf8 += static_cast<char>(0xE0 | character >> 12);
    tail(6), tail(0);
  } else {
    utf8 += static_cast<char>(0xF0 | character >> 18);
    tail(12), tail(6), tail(0);
  }
}

// Eight bytes at a time: sources of many megabytes are almost always plain ASCII.
bool isAscii(std::string_view text) {
  std::uint64_t high = 0;
  for (; text.size() >= sizeof high; text.remove_prefix(sizeof high)) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, text.data(), sizeof eight);
    high |= eight;
  }
  for (const char c : text) high |= static_cast<unsigned char>(c);
  return (high & 0x8080808080808080) == 0;
}

bool isValidUtf8(std::string_view text) {
  if (isAscii(text)) return true;
  for (std::size_t i = 0; i < text.size();) {
    if (static_cast<unsigned char>(text[i]) < 0x80) {
      ++i;
      continue;
    }
    const unsigned length = sequenceLength(static_cast<unsigned char>(text[i]));
    if (decode(text, i, length) > 0x10FFFF) return false;
    i += length;
  }
  return true;
}

}  // namespace merker
