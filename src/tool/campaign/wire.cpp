#include "campaign/wire.h"

#include <fmt/format.h>

#include <charconv>

namespace merker::campaign {
namespace {

constexpr std::size_t kLongestMessage = 1000;
constexpr char kBetween = '\t';

// The next field as a number; false at the end or if it is none.
template <typename Number>
bool take(std::string_view& line, Number& number) {
  const auto end = line.find(kBetween);
  const std::string_view field = line.substr(0, end);
  line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
  const auto [behind, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  return error == std::errc() && behind == field.data() + field.size();
}

// Not inside a character of UTF-8, and without what separates.
std::string tidy(std::string text) {
  std::size_t end = std::min(text.size(), kLongestMessage);
  while (end > 0 && end < text.size() && (text[end] & 0xC0) == 0x80) --end;
  text.resize(end);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

}  // namespace

std::string encode(std::uint64_t number, const Outcome& outcome) {
  std::string line = fmt::format("{}\t{}\t{}\t{}\t{}", number, outcome.passed ? 1 : 0,
                                 outcome.seconds, outcome.cycles, outcome.measures.size());
  for (const auto& measure : outcome.measures)
    line += measure ? fmt::format("\t{}", *measure) : "\tnan";
  return line + kBetween + tidy(outcome.message) + '\n';
}

std::optional<Arrived> decode(std::string_view line) {
  Arrived arrived;
  Outcome& outcome = arrived.outcome;
  int passed = 0;
  std::size_t measures = 0;
  if (!take(line, arrived.number) || !take(line, passed) || !take(line, outcome.seconds) ||
      !take(line, outcome.cycles) || !take(line, measures) || measures > kMostMeasures)
    return std::nullopt;
  for (std::size_t i = 0; i < measures; ++i) {
    double value = 0;
    if (!take(line, value)) return std::nullopt;
    outcome.measures.push_back(value == value ? std::optional(value) : std::nullopt);
  }
  outcome.passed = passed != 0;
  outcome.message = line;
  return arrived;
}

}  // namespace merker::campaign
