#include "base/letter_costs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/code_page.h"
#include "base/utf8.h"

namespace merker {
namespace {

// Bits: what is seen once in 32 texts costs 5.
constexpr double kUsualSign = 5, kSign = 8, kForeign = 11, kUnassigned = 16;
constexpr double kCapital = 2, kCapitalInWord = 5, kSignInWord = 5, kRepeated = 0.2;
constexpr double kMixedScripts = 5, kAloneOfOther = 1, kWithoutAscii = 3, kSideBySide = 1;

constexpr std::string_view kUsualSigns = "°²³µ§±–—„“”’‘…€№«»·©®½¼¾×÷¿¡ªº™•\u00A0";
constexpr std::string_view kVowels = "оеаиуыяюэёіїєОЕАИУЫЯЮЭЁІЇЄαοιεηυωίόάέήύώϊΑΟΙΕΗΥΩΊΌΆΈΉΎΏΪ";

// The place of a character in a list of them.
std::optional<std::size_t> placeIn(std::string_view list, std::string_view character) {
  std::size_t place = 0;
  for (std::size_t at = 0; at < list.size(); ++place) {
    const std::size_t begin = at;
    nextCharacter(list, at);
    if (list.substr(begin, at - begin) == character) return place;
  }
  return std::nullopt;
}

std::size_t lengthOf(std::string_view list) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < list.size(); ++count) nextCharacter(list, at);
  return count;
}

// Frequencies of letters fall by about the same factor from each to the next.
double bitsOf(std::size_t place, std::string_view list) {
  const auto count = static_cast<double>(lengthOf(list));
  return std::log2(count) - 2 + (static_cast<double>(place) + 0.5) * 5.5 / count;
}

// Latin, Greek and Cyrillic.
bool isAlphabetic(std::string_view character) {
  std::size_t at = 0;
  const char32_t c = nextCharacter(character, at);
  return (c >= 0xC0 && c < 0x250 && c != U'×' && c != U'÷') || (c >= 0x370 && c < 0x530);
}

}  // namespace

void LetterCosts::assign(Byte& byte, std::string_view character, std::string_view small,
                         std::string_view capital, std::string_view alone) {
  byte.alone = placeIn(alone, character).has_value();
  byte.vowel = placeIn(kVowels, character).has_value();
  byte.power = character == "²" || character == "³";
  if (const auto place = placeIn(small, character)) {
    byte = {Kind::Small, bitsOf(*place, small), byte.alone, false, byte.vowel};
  } else if (const auto upper = placeIn(capital, character)) {
    byte = {Kind::Capital, bitsOf(*upper, capital), byte.alone, false, byte.vowel};
  } else if (isAlphabetic(character)) {
    byte = {Kind::Foreign, kForeign, byte.alone, false, byte.vowel};
  } else {
    byte.kind = Kind::Sign;
    byte.bits = character == "\uFFFD"             ? kUnassigned
                : placeIn(kUsualSigns, character) ? kUsualSign
                                                  : kSign;
  }
}

LetterCosts::LetterCosts(unsigned page, double prior, Script script, std::string_view small,
                         std::string_view capital, std::string_view alone)
    : page_(page), prior_(prior), script_(script) {
  for (std::size_t c = 'a'; c <= 'z'; ++c) bytes_[c].kind = Kind::AsciiSmall;
  for (std::size_t c = 'A'; c <= 'Z'; ++c) bytes_[c].kind = Kind::AsciiCapital;
  const CodePage characters(page);
  for (std::size_t c = 0x80; c < bytes_.size(); ++c) {
    const char byte = static_cast<char>(c);
    assign(bytes_[c], characters.toUtf8({&byte, 1}), small, capital, alone);
  }
}

double LetterCosts::ofLetter(const Byte& byte, Kind before, Kind behind) const {
  double bits = byte.bits;
  if (byte.kind == Kind::Capital) {
    if (before != Kind::Capital && before != Kind::AsciiCapital) bits += kCapital;
    if (before == Kind::Small || before == Kind::AsciiSmall) bits += kCapitalInWord;
  }
  const bool alone = !isLetter(before) && !isLetter(behind);
  if (script_ == Script::Other)
    return bits + (isAsciiLetter(before) ? kMixedScripts : 0) +
           (isAsciiLetter(behind) ? kMixedScripts : 0) + (alone ? kAloneOfOther : 0);
  if (alone && byte.alone) return bits;
  if (!isAsciiLetter(before) && !isAsciiLetter(behind)) return bits + kWithoutAscii;
  return bits + (isLetter(before) && !isAsciiLetter(before) ? kSideBySide : 0);
}

double LetterCosts::ofRow(std::size_t length) {
  constexpr double kBits[] = {0, 0, 1, 3, 5};
  return kBits[std::min(length, std::size(kBits) - 1)];
}

double LetterCosts::ofSign(std::string_view words, std::size_t at, Kind before, Kind behind) const {
  const Byte& byte = byteOf(words, at);
  const bool metre = at > 0 && (words[at - 1] == 'm' || words[at - 1] == 'M');
  if (byte.power && metre && (at < 2 || !isLetter(byteOf(words, at - 2).kind))) return 1;
  if (at > 0 && words[at - 1] == words[at]) return byte.bits * kRepeated;
  const bool apostrophe = words[at] == '\x92';
  const bool inWord = isLetter(before) && isLetter(behind) && !apostrophe;
  return byte.bits + (inWord ? kSignInWord : 0);
}

const LetterCosts::Byte& LetterCosts::byteOf(std::string_view words, std::size_t at) const {
  return bytes_[at < words.size() ? static_cast<std::uint8_t>(words[at]) : 0];
}

double LetterCosts::of(std::string_view words) const {
  double bits = prior_;
  std::size_t row = 0;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const Byte& byte = byteOf(words, at);
    const bool known = byte.kind == Kind::Small || byte.kind == Kind::Capital;
    row = !known ? 0 : row > 0 && byte.vowel == byteOf(words, at - 1).vowel ? row + 1 : 1;
    if (static_cast<std::uint8_t>(words[at]) < 0x80) continue;
    if (script_ == Script::Other) bits += ofRow(row);
    const Kind before = at > 0 ? byteOf(words, at - 1).kind : Kind::Blank;
    const Kind behind = byteOf(words, at + 1).kind;
    bits +=
        isLetter(byte.kind) ? ofLetter(byte, before, behind) : ofSign(words, at, before, behind);
  }
  return bits;
}

const std::vector<LetterCosts>& letterCosts() {
  using enum LetterCosts::Script;
  struct InPage {
    unsigned page;
    double prior;
  };
  static const std::vector<LetterCosts> kCosts = [] {
    std::vector<LetterCosts> list;
#define LANGUAGE(script, small, capital, alone, ...)                 \
  for (const InPage& in : std::initializer_list<InPage> __VA_ARGS__) \
    list.emplace_back(in.page, in.prior, script, small, capital, alone);
#include "base/languages.inc"
#undef LANGUAGE
    return list;
  }();
  return kCosts;
}

// GB 2312: rows 16 to 55 are the usual characters, the ones behind them rare, 1 to 3 signs.
double chineseCost(std::string_view words) {
  constexpr double kPrior = 6, kUsual = 10.5, kOfSigns = 9, kRare = 17, kNoPair = 20;
  double bits = kPrior;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const auto lead = static_cast<std::uint8_t>(words[at]);
    if (lead < 0x80) continue;
    const auto trail = static_cast<std::uint8_t>(at + 1 < words.size() ? words[at + 1] : 0);
    const bool usual = lead >= 0xB0 && lead <= 0xD7, rare = lead >= 0xD8 && lead <= 0xF7;
    const bool sign = lead >= 0xA1 && lead <= 0xA3;
    const bool pair = trail >= 0xA1 && trail <= 0xFE && (usual || rare || sign);
    bits += !pair ? kNoPair : usual ? kUsual : rare ? kRare : kOfSigns;
    if (pair) ++at;
  }
  return bits;
}

}  // namespace merker
