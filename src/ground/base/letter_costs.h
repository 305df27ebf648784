// How unlikely the bytes of a text are if it is in a language and a code page.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace merker {

// One language in one page.
class LetterCosts {
 public:
  enum class Script : std::uint8_t { Latin, Other };
  LetterCosts(unsigned page, double prior, Script script, std::string_view small,
              std::string_view capital, std::string_view alone);
  unsigned page() const { return page_; }
  // In bits; the smallest is the most likely one. `words`: between blanks.
  double of(std::string_view words) const;

 private:
  enum class Kind : std::uint8_t { Blank, AsciiSmall, AsciiCapital, Small, Capital, Foreign, Sign };
  struct Byte {
    Kind kind = Kind::Blank;
    double bits = 0;
    bool alone = false;  // a word of this letter alone is usual
    bool power = false;  // the 3 of m3
    bool vowel = false;
  };
  static bool isLetter(Kind kind) { return kind != Kind::Blank && kind != Kind::Sign; }
  static bool isAsciiLetter(Kind kind) {
    return kind == Kind::AsciiSmall || kind == Kind::AsciiCapital;
  }
  double ofLetter(const Byte& byte, Kind before, Kind behind) const;
  // Of a letter that is the `length`th one of only vowels, or only consonants, in its word.
  static double ofRow(std::size_t length);
  double ofSign(std::string_view words, std::size_t at, Kind before, Kind behind) const;
  const Byte& byteOf(std::string_view words, std::size_t at) const;
  void assign(Byte& byte, std::string_view character, std::string_view small,
              std::string_view capital, std::string_view alone);

  unsigned page_;
  double prior_;
  Script script_;
  std::array<Byte, 256> bytes_;
};

// Every language in every page of it.
const std::vector<LetterCosts>& letterCosts();
// Of a text in Chinese, page 936: two bytes a character.
double chineseCost(std::string_view words);

}  // namespace merker
