#include "gsd/values.h"

#include <fmt/format.h>

#include <charconv>

#include "base/text.h"

namespace merker::gsd {
namespace {

bool isPlain(const Word& word) { return word.kind == Word::Kind::Plain; }

std::optional<std::int64_t> digits(std::string_view text, int base) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, base);
  if (text.empty() || read.ec != std::errc{} || read.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::int64_t> number(std::string_view text) {
  text = trim(text);
  if (text.starts_with("0x") || text.starts_with("0X")) return digits(text.substr(2), 16);
  if (text.ends_with('h') || text.ends_with('H'))
    return digits(text.substr(0, text.size() - 1), 16);
  return digits(text, 10);
}

std::optional<std::int64_t> firstNumber(const Statement& statement) {
  for (const Word& word : statement.values)
    if (isPlain(word)) return number(word.text);
  return std::nullopt;
}

std::string firstText(const Statement& statement) {
  for (const Word& word : statement.values)
    if (word.kind == Word::Kind::Text) return std::string(trim(word.text));
  return wholeText(statement);
}

std::string wholeText(const Statement& statement) {
  std::string text;
  for (const Word& word : statement.values)
    text += (text.empty() || word.text == "," ? "" : " ") + word.text;
  return text;
}

// The minus between the two is not the sign of the first.
std::optional<std::pair<std::int64_t, std::int64_t>> range(std::string_view text) {
  const auto minus = text.find('-', 1);
  const auto low = number(text.substr(0, minus));
  const auto high = minus == std::string_view::npos ? low : number(text.substr(minus + 1));
  if (text.empty() || !low || !high) return std::nullopt;
  return std::pair{*low, *high};
}

Ranges ranges(const Statement& statement, std::size_t from) {
  Ranges found;
  std::string item;
  const auto take = [&] {
    if (const auto one = range(item)) found.push_back(*one);
    item.clear();
  };
  for (std::size_t i = from; i < statement.values.size(); ++i) {
    const Word& word = statement.values[i];
    if (isPlain(word))
      item += word.text;
    else
      take();
  }
  take();
  return found;
}

Bytes bytes(const Statement& statement, const source::SourceFile& file,
            std::vector<Remark>& remarks) {
  Bytes list;
  const Word* before = nullptr;
  for (const Word& word : statement.values) {
    if (isPlain(word)) {
      const auto value = number(word.text);
      if (!value || *value < 0 || *value > 0xFF)
        remarks.push_back(
            remarkAt(file, word.offset, fmt::format("'{}' must be a byte, 0 to 0xFF", word.text)));
      else if (before != nullptr && isPlain(*before))
        remarks.push_back(
            remarkAt(file, word.offset, fmt::format("there must be a comma before {}", word.text)));
      if (value) list.push_back(static_cast<std::uint8_t>(*value));
    }
    before = &word;
  }
  return list;
}

}  // namespace merker::gsd
