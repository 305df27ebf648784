#include "nc/number_format.h"

#include "nc/bcd_value.h"

namespace merker::nc {
namespace {

enum class Coding : std::uint8_t { Bcd, Fixed, Stored, Pattern };

// Places behind the point with metric and inch input; a point is shown from the digit 1 on.
struct Row {
  std::string_view name;
  Coding coding = Coding::Bcd;
  std::uint8_t metric = 0, inch = 0;
  bool counts = false;  // B0, F0: no point, the number in the unit of its data type
  bool point = true;
};

constexpr std::array<Row, 28> kRows{{
    {"B0", Coding::Bcd, 0, 0, true, false},
    {"B1", Coding::Bcd, 0, 0},
    {"B2", Coding::Bcd, 1, 1},
    {"B3", Coding::Bcd, 2, 2},
    {"B4", Coding::Bcd, 3, 3},
    {"B5", Coding::Bcd, 4, 4},
    {"B6", Coding::Bcd, 5, 5},
    {"B7", Coding::Bcd, 6, 6},
    {"B8", Coding::Bcd, 7, 7},
    {"B9", Coding::Bcd, 8, 8},
    {"F0", Coding::Fixed, 0, 0, true, false},
    {"F1", Coding::Fixed, 0, 0},
    {"F2", Coding::Fixed, 1, 1},
    {"F3", Coding::Fixed, 2, 2},
    {"F4", Coding::Fixed, 3, 3},
    {"F5", Coding::Fixed, 4, 4},
    {"F6", Coding::Fixed, 5, 5},
    {"F7", Coding::Fixed, 6, 6},
    {"F8", Coding::Fixed, 7, 7},
    {"F9", Coding::Fixed, 8, 8},
    {"FA", Coding::Fixed, 3, 4},  // linear position
    {"FB", Coding::Fixed, 3, 3},  // rotary position
    {"FC", Coding::Fixed, 2, 3},  // feed linear
    {"FD", Coding::Fixed, 2, 2},  // feed rotary
    {"FE", Coding::Fixed, 3, 4},  // feed per revolution
    {"FF", Coding::Fixed, 0, 0},  // speed
    {"BG", Coding::Stored},
    {"BI", Coding::Pattern},
}};
constexpr unsigned kPatternDigits = 8;

const Row& row(Format format) { return kRows[static_cast<std::size_t>(format)]; }

// Places behind the point that the format wants of a data type with this content.
unsigned places(const Row& r, Content content, InputSystem system) {
  if (r.counts && content == Content::Position) return positionPlaces(system);
  return system == InputSystem::Metric ? r.metric : r.inch;
}

std::uint16_t word(std::uint64_t value, unsigned shift) {
  return static_cast<std::uint16_t>(value >> shift);
}

std::optional<PlcValue> encodeBcd(std::int64_t digits, unsigned places, bool point) {
  if (!makeNumber(digits, places)) return std::nullopt;
  const bool negative = digits < 0;
  const std::uint64_t sign = negative ? std::uint64_t{1} << 36 : 0;
  const auto nibbles =
      sign | bcdNibbles(static_cast<std::uint64_t>(negative ? -digits : digits), places, point);
  return PlcValue{{word(nibbles, 32), word(nibbles, 16), word(nibbles, 0)}, 3};
}

std::optional<PlcValue> encodeFixed(std::int64_t value) {
  if (value != static_cast<std::int32_t>(value)) return std::nullopt;
  const auto bits = static_cast<std::uint32_t>(value);
  return PlcValue{{word(bits, 16), word(bits, 0)}, 2};
}

// Digits 0 and 1 are bits, the last digit is bit 0 (S5-FM-40).
std::optional<PlcValue> encodePattern(Number n) {
  if (n.places != 0 || n.digits < 0) return std::nullopt;
  PlcValue result;
  std::int32_t rest = n.digits;
  for (unsigned bit = 0; bit < kPatternDigits; ++bit, rest /= 10) {
    if (rest % 10 > 1) return std::nullopt;
    result.words[0] = static_cast<std::uint16_t>(result.words[0] | (rest % 10) << bit);
  }
  return result;
}

std::optional<Number> decodePattern(std::uint16_t bits) {
  if (bits >> kPatternDigits != 0) return std::nullopt;
  std::int32_t digits = 0;
  for (unsigned bit = kPatternDigits; bit-- > 0;) digits = digits * 10 + (bits >> bit & 1);
  return Number{digits, 0};
}

std::optional<Number> decodeBcd(std::span<const std::uint16_t> words, const Row& r,
                                unsigned wanted) {
  const std::uint64_t nibbles =
      std::uint64_t{words[0] & 0xFFu} << 32 | std::uint64_t{words[1]} << 16 | words[2];
  const auto bcd = parseBcd(nibbles);
  if (!bcd) return std::nullopt;
  const unsigned behind = bcd->places.value_or(r.counts ? wanted : 0);
  if (r.coding == Coding::Stored) return makeNumber(bcd->digits, behind);
  return makeNumber(scaled(bcd->digits, behind, wanted), wanted);
}

}  // namespace

std::optional<Format> parseFormat(std::uint16_t characters) {
  const char text[] = {static_cast<char>(characters >> 8), static_cast<char>(characters & 0xFF)};
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (kRows[i].name == std::string_view(text, 2)) return static_cast<Format>(i);
  return std::nullopt;
}

std::string_view name(Format format) { return row(format).name; }

unsigned wordCount(Format format) {
  const Coding coding = row(format).coding;
  return coding == Coding::Fixed ? 2 : coding == Coding::Pattern ? 1 : 3;
}

std::optional<PlcValue> encode(Number n, Format format, Content content, InputSystem system) {
  const Row& r = row(format);
  const unsigned wanted = places(r, content, system);
  switch (r.coding) {
    case Coding::Bcd:
      return encodeBcd(scaled(n, wanted), wanted, r.point);
    case Coding::Fixed:
      return encodeFixed(scaled(n, wanted));
    case Coding::Stored:
      return encodeBcd(n.digits, n.places, true);
    case Coding::Pattern:
      break;
  }
  if (content == Content::Bits) return PlcValue{{static_cast<std::uint16_t>(n.digits)}, 1};
  return encodePattern(n);
}

std::optional<Number> decode(std::span<const std::uint16_t> words, Format format, Content content,
                             InputSystem system) {
  const Row& r = row(format);
  const unsigned wanted = places(r, content, system);
  switch (r.coding) {
    case Coding::Bcd:
    case Coding::Stored:
      return decodeBcd(words, r, wanted);
    case Coding::Fixed:
      return makeNumber(static_cast<std::int32_t>(std::uint32_t{words[0]} << 16 | words[1]),
                        wanted);
    case Coding::Pattern:
      break;
  }
  if (content == Content::Bits) return words[0] > 0xFF ? std::nullopt : makeNumber(words[0], 0);
  return decodePattern(words[0]);
}

}  // namespace merker::nc
