#include "importing/file_text.h"

#include <algorithm>

namespace merker::importing {
namespace {

constexpr std::string_view kReplacementText = "\uFFFD";

bool isUtf16(Encoding encoding) {
  return encoding == Encoding::Utf16Le || encoding == Encoding::Utf16Be;
}

std::size_t countOf(std::string_view text, std::string_view what) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string_view::npos; at += what.size())
    ++count;
  return count;
}

bool isControl(char c) {
  constexpr std::string_view kOfTexts = "\t\n\v\f\r\x1A";
  return static_cast<unsigned char>(c) < ' ' && kOfTexts.find(c) == std::string_view::npos;
}

void tellPage(const std::string& path, const PageGuess& guess, bool named, Report& report) {
  const Note note = named ? Note::NamedPage : guess.certain ? Note::GuessedPage : Note::UnsurePage;
  report.add(note, path, guess.page);
}

PageGuess chosen(const PageGuess& own, const Page& page) {
  if (own.page == 0) return own;
  if (page.named != 0) return {page.named, true};
  return own.certain || page.common.page == 0 ? own : page.common;
}

std::string nameOf(Encoding encoding, unsigned page) {
  if (isUtf16(encoding)) return "UTF-16";
  return page == 0 ? "UTF-8" : fmt::format("code page {}", page);
}

}  // namespace

std::string withoutZeros(std::string bytes) {
  constexpr std::size_t kFew = 16;  // bytes for each of them
  if (formOf(bytes).encoding != Encoding::Binary) return bytes;
  std::string out = bytes;
  while (out.ends_with('\0')) out.pop_back();
  const auto zeros = static_cast<std::size_t>(std::ranges::count(out, '\0'));
  if (zeros * kFew > out.size()) return bytes;
  std::ranges::replace(out, '\0', ' ');
  return out;
}

std::optional<std::string> readText(const std::string& path, std::string bytes, const Page& page,
                                    Report& report) {
  std::string clean = withoutZeros(bytes);
  const std::size_t zero = bytes.find('\0');
  if (zero < clean.size() && clean[zero] == ' ')
    report.add(
        Note::ZeroBytes, path,
        std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(clean.size()), '\0'),
        zero);
  const TextForm form = formOf(clean);
  if (form.encoding == Encoding::Binary) {
    report.add(Note::NotText, path, std::ranges::count_if(bytes, isControl), bytes.size());
    return std::nullopt;
  }
  if (isUtf16(form.encoding)) {
    report.add(Note::FromUtf16, path);
    if (clean.size() % 2 != 0) {
      report.add(Note::OddUtf16, path);
      clean.pop_back();
    }
  }
  const PageGuess guess = chosen(form.guess, page);
  if (guess.page != 0) tellPage(path, guess, page.named != 0, report);
  std::optional<std::string> text = decoded(clean, guess.page);
  const std::size_t wrong = text ? countOf(*text, kReplacementText) : 0;
  if (wrong > 0) report.add(Note::WrongCharacters, path, wrong, nameOf(form.encoding, guess.page));
  return text;
}

}  // namespace merker::importing
