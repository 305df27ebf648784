#include "scenario/serial_text.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "base/text.h"
#include "scenario/line.h"

namespace merker::simulator {
namespace {

constexpr std::size_t kMostCharacters = 8'192;

constexpr std::pair<std::string_view, std::uint8_t> kNames[] = {
    {"NUL", 0x00}, {"SOH", 0x01}, {"STX", 0x02},  {"ETX", 0x03}, {"EOT", 0x04}, {"ENQ", 0x05},
    {"ACK", 0x06}, {"BS", 0x08},  {"HT", 0x09},   {"LF", 0x0A},  {"FF", 0x0C},  {"CR", 0x0D},
    {"DLE", 0x10}, {"XON", 0x11}, {"XOFF", 0x13}, {"NAK", 0x15}, {"ESC", 0x1B}, {"SP", 0x20}};

std::string names() {
  std::string list;
  for (const auto& [name, value] : kNames)
    if (name != "FF") list += fmt::format("{}{}", list.empty() ? "" : ", ", name);
  return list;
}

std::optional<std::uint8_t> hexadecimal(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.size() != 2 || error != std::errc{} || end != text.data() + 2) return std::nullopt;
  return static_cast<std::uint8_t>(value);
}

std::optional<std::size_t> countOf(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || text.size() > 5 || error != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

std::uint8_t blockCheck(const serial::Bytes& bytes) {
  std::uint8_t check = 0;
  for (const std::uint8_t byte : bytes) check = static_cast<std::uint8_t>(check ^ byte);
  return check;
}

// FF is a value here, not a form feed.
bool addOne(std::string_view word, serial::Bytes& bytes) {
  if (const auto value = hexadecimal(word)) return bytes.push_back(*value), true;
  for (const auto& [name, value] : kNames)
    if (equalsIgnoreCase(name, word)) return bytes.push_back(value), true;
  const bool wrong = word.starts_with('!');
  if (!equalsIgnoreCase(word.substr(wrong ? 1 : 0), "BCC")) return false;
  const std::uint8_t check = blockCheck(bytes);
  bytes.push_back(wrong ? static_cast<std::uint8_t>(check ^ 1U) : check);
  return true;
}

// 00..FF, 55*128
bool addSeveral(std::string_view word, serial::Bytes& bytes) {
  if (const auto dots = word.find(".."); dots != std::string_view::npos) {
    const auto first = hexadecimal(word.substr(0, dots)), last = hexadecimal(word.substr(dots + 2));
    if (!first || !last || *first > *last) return false;
    for (unsigned value = *first; value <= *last; ++value)
      bytes.push_back(static_cast<std::uint8_t>(value));
    return true;
  }
  const auto star = word.find('*');
  if (star == std::string_view::npos) return false;
  const auto value = hexadecimal(word.substr(0, star));
  const auto count = countOf(word.substr(star + 1));
  if (!value || !count || *count > kMostCharacters) return false;
  bytes.insert(bytes.end(), *count, *value);
  return true;
}

bool isPrintable(std::uint8_t c) { return c >= 0x20 && c < 0x7F && c != '\''; }

}  // namespace

bool parseCharacters(const StepLine& line, std::string_view text, serial::Bytes& bytes) {
  text = trim(text);
  if (text.empty()) return line.fail(ProblemCode::P0952, line.rest(), "characters: 02 \"ABC\" 0D");
  while (!text.empty()) {
    const bool quoted = text.front() == '"';
    const auto end = quoted ? text.find('"', 1) : std::min(text.find_first_of(" \t"), text.size());
    const std::string_view word = text.substr(0, end);
    const bool good =
        quoted ? end != std::string_view::npos : addOne(word, bytes) || addSeveral(word, bytes);
    if (!good || bytes.size() > kMostCharacters)
      return line.fail(ProblemCode::P0994, word, word, names());
    if (quoted) bytes.insert(bytes.end(), word.begin() + 1, word.end());
    text = trim(text.substr(end + (quoted ? 1 : 0)));
  }
  return true;
}

std::string showCharacters(const serial::Bytes& bytes) {
  constexpr std::size_t kShown = 64;
  std::string text;
  bool quoted = false;
  for (std::size_t i = 0; i < std::min(bytes.size(), kShown); ++i) {
    const bool printable = isPrintable(bytes[i]);
    if (printable != quoted) text += printable ? (text.empty() ? "\"" : " \"") : "\"";
    quoted = printable;
    if (printable)
      text += static_cast<char>(bytes[i]);
    else
      text += fmt::format("{}{:02X}", text.empty() ? "" : " ", bytes[i]);
  }
  if (quoted) text += '"';
  if (bytes.size() > kShown) text += fmt::format(" ... ({} characters)", bytes.size());
  return text;
}

std::optional<serial::LinkJob> parseArea(std::string_view text) {
  serial::LinkJob job;
  const std::string word = upper(text);
  const std::string_view rest = word;
  if (rest.starts_with("DB") || rest.starts_with("DX")) {
    const auto point = rest.find(".DBB");
    if (point == std::string_view::npos) return std::nullopt;
    const auto block = countOf(rest.substr(2, point - 2)), offset = countOf(rest.substr(point + 4));
    if (!block || !offset || *block > 255 || *offset > 2'047) return std::nullopt;
    job.type = rest[1] == 'B' ? 'D' : 'X';
    job.block = static_cast<std::uint8_t>(*block);
    job.offset = static_cast<std::uint16_t>(*offset);
    return job;
  }
  const bool words = rest.starts_with('T') || rest.starts_with('Z');
  const bool byte = rest.size() > 1 && rest[1] == 'B' &&
                    std::string_view("MEA").find(rest[0]) != std::string_view::npos;
  if (!words && !byte) return std::nullopt;
  const auto offset = countOf(rest.substr(words ? 1 : 2));
  if (!offset || *offset > 65'535) return std::nullopt;
  job.type = rest[0];
  job.offset = static_cast<std::uint16_t>(*offset);
  return job;
}

}  // namespace merker::simulator
