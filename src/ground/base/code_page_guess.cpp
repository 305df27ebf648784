// Which code page a text is in, by its content.
#include <algorithm>
#include <cstdint>

#include "base/code_page.h"
#include "base/letter_costs.h"
#include "base/text.h"
#include "base/utf8.h"

namespace merker {
namespace {

bool isHigh(char c) { return static_cast<std::uint8_t>(c) >= 0x80; }
bool isSpace(char c) { return static_cast<std::uint8_t>(c) <= ' '; }

// The words that have other bytes than ASCII, as many as tell enough.
std::string foreignWords(std::string_view text) {
  constexpr std::size_t kEnough = 4u << 10;
  std::string out;
  for (std::size_t i = 0; i < text.size() && out.size() < kEnough;) {
    const std::size_t begin = i;
    bool high = false;
    while (i < text.size() && !isSpace(text[i])) high |= isHigh(text[i++]);
    if (high) out.append(text.substr(begin, std::min(i - begin, kEnough))).push_back(' ');
    ++i;
  }
  return out;
}

// Letters of German and of the Nordic languages, which lists of them have side by side.
double northernBonus(std::string_view words) {
  constexpr double kBonus = 6;
  constexpr std::string_view kNorthern = "\xC4\xD6\xDC\xE4\xF6\xFC\xDF\xC5\xC6\xD8\xE5\xE6\xF8";
  const bool all = std::ranges::all_of(
      words, [&](char c) { return !isHigh(c) || kNorthern.find(c) != std::string_view::npos; });
  return all ? kBonus : 0;
}

struct Candidate {
  unsigned page;
  double bits;
};

std::vector<Candidate> candidates(std::string_view words) {
  std::vector<Candidate> list{{936, chineseCost(words)}};
  for (const LetterCosts& costs : letterCosts()) {
    const double bonus = costs.page() == 1252 ? northernBonus(words) : 0;
    list.push_back({costs.page(), costs.of(words) - bonus});
  }
  std::ranges::stable_sort(list, {}, &Candidate::bits);
  return list;
}

// UTF-16 without its mark: every other byte of ASCII text is 0.
std::optional<Encoding> unmarkedUtf16(std::string_view bytes) {
  std::size_t zeros[2] = {};
  for (std::size_t i = 0; i < bytes.size(); ++i) zeros[i % 2] += bytes[i] == '\0';
  const bool half = (zeros[0] + zeros[1]) * 4 > bytes.size();
  if (!half || (zeros[0] > 0 && zeros[1] > 0)) return std::nullopt;
  return zeros[0] > 0 ? Encoding::Utf16Be : Encoding::Utf16Le;
}

// Most sequences are right: a file of which some bytes are damaged.
bool isBrokenUtf8(std::string_view bytes) {
  constexpr std::size_t kRightForEachWrong = 4;
  std::size_t right = 0, wrong = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t begin = at;
    const bool good = nextCharacter(bytes, at) != kReplacement;
    if (isHigh(bytes[begin])) good ? ++right : ++wrong;
  }
  return right > wrong * kRightForEachWrong;
}

unsigned pageOf(Encoding encoding) {
  return encoding == Encoding::Cp850 ? 850 : encoding == Encoding::Cp437 ? 437 : 1252;
}

}  // namespace

PageGuess guessedPage(std::string_view bytes) {
  constexpr double kCertain = 5;
  const std::string words = foreignWords(bytes);
  if (words.empty()) return {};
  const std::vector<Candidate> list = candidates(words);
  const std::string best = CodePage(list.front().page).toUtf8(words);
  // Pages that have the same letters at these places give the same text.
  const auto other = std::ranges::find_if(list, [&](const Candidate& candidate) {
    return candidate.page != list.front().page && CodePage(candidate.page).toUtf8(words) != best;
  });
  const double margin = other == list.end() ? kCertain : other->bits - list.front().bits;
  return {list.front().page, margin >= kCertain};
}

TextForm formOf(std::string_view bytes) {
  TextForm form;
  form.encoding = detectEncoding(bytes);
  if (form.encoding == Encoding::Binary)
    form.encoding = unmarkedUtf16(bytes).value_or(Encoding::Binary);
  const bool wide = form.encoding == Encoding::Utf16Le || form.encoding == Encoding::Utf16Be;
  if (wide || form.encoding == Encoding::Utf8 || form.encoding == Encoding::Binary) return form;
  if (isBrokenUtf8(bytes))
    form.encoding = Encoding::Utf8;
  else if (form.encoding == Encoding::Cp1252)
    form.guess = guessedPage(bytes);
  else
    form.guess = {pageOf(form.encoding), true};
  return form;
}

std::optional<std::string> decoded(std::string_view bytes, unsigned page) {
  const TextForm form = formOf(bytes);
  if (form.encoding == Encoding::Binary) return std::nullopt;
  if (form.guess.page == 0) return toUtf8(bytes, form.encoding);
  return CodePage(page != 0 ? page : form.guess.page).toUtf8(bytes);
}

}  // namespace merker
