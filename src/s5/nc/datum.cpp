#include "nc/datum.h"

#include <fmt/format.h>

#include <charconv>

#include "base/text.h"

namespace merker::nc {
namespace {

constexpr std::string_view kPrefix = "nc.";
// Bits of a packed datum: row + 1, then the numbers.
constexpr unsigned kFirstBits = 14, kSecondBits = 10, kThirdBits = 2;

bool called(const DatumRow& row, std::string_view name) {
  return equalsIgnoreCase(row.name, name) ||
         (!row.alias.empty() && equalsIgnoreCase(row.alias, name));
}

bool knownName(std::string_view name) {
  for (const DatumRow& row : datumRows())
    if (called(row, name)) return true;
  return false;
}

// "tool 5.2" to "tool" and "5.2"; also "R50".
std::pair<std::string_view, std::string_view> split(std::string_view text) {
  auto end = text.find_first_of(" \t");
  if (end == std::string_view::npos && !knownName(text)) end = text.find_first_of("0123456789");
  if (end == std::string_view::npos) return {text, {}};
  return {text.substr(0, end), trim(text.substr(end))};
}

struct Numbers {
  std::array<int, 3> values{};
  unsigned count = 0;
};

// "2.50"; nothing if these are no numbers.
std::optional<Numbers> parseNumbers(std::string_view text) {
  Numbers result;
  while (!text.empty()) {
    if (result.count == result.values.size()) return std::nullopt;
    int& value = result.values.at(result.count++);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || value < 0) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty()) return result;
    if (text.front() != '.' || text.size() == 1) return std::nullopt;
    text.remove_prefix(1);
  }
  return result;
}

// The numbers with those that were left out.
std::optional<Where> complete(const DatumRow& row, Numbers given) {
  const unsigned wanted = indexCount(row);
  if (given.count + 1 == wanted && row.first) {
    for (unsigned i = given.count; i > 0; --i) given.values.at(i) = given.values.at(i - 1);
    given.values[0] = *row.first;
  } else if (given.count + 1 == wanted && row.last) {
    given.values.at(given.count) = *row.last;
  } else if (given.count != wanted) {
    return std::nullopt;
  }
  for (unsigned i = 0; i < wanted; ++i)
    if (given.values.at(i) < row.limits.at(i).low || given.values.at(i) > row.limits.at(i).high)
      return std::nullopt;
  return given.values;
}

std::string rangeText(const DatumRow& row) {
  std::string text;
  for (unsigned i = 0; i < indexCount(row); ++i) {
    const Limit& limit = row.limits.at(i);
    text += fmt::format("{}{}", i == 0 ? "" : ".", limit.low);
    if (limit.high != limit.low) text += fmt::format("..{}", limit.high);
  }
  return text;
}

}  // namespace

unsigned indexCount(const DatumRow& row) {
  unsigned count = 0;
  while (count < row.limits.size() && row.limits.at(count).used()) ++count;
  return count;
}

const DatumRow& rowOf(const Datum& datum) { return datumRows()[datum.row]; }

std::uint32_t pack(const Datum& datum) {
  auto packed = static_cast<std::uint32_t>(datum.row + 1);
  packed = packed << kFirstBits | static_cast<std::uint32_t>(datum.where[0]);
  packed = packed << kSecondBits | static_cast<std::uint32_t>(datum.where[1]);
  return packed << kThirdBits | static_cast<std::uint32_t>(datum.where[2]);
}

Datum unpack(std::uint32_t packed) {
  const auto take = [&](unsigned bits) {
    const auto value = static_cast<int>(packed & ((1u << bits) - 1));
    packed >>= bits;
    return value;
  };
  Datum datum;
  datum.where[2] = take(kThirdBits);
  datum.where[1] = take(kSecondBits);
  datum.where[0] = take(kFirstBits);
  datum.row = packed - 1;
  return datum;
}

bool namesDatum(std::string_view text) {
  return equalsIgnoreCase(text.substr(0, kPrefix.size()), kPrefix);
}

std::optional<Datum> parseDatum(std::string_view text) {
  if (!namesDatum(text)) return std::nullopt;
  const auto [name, index] = split(trim(text.substr(kPrefix.size())));
  const auto numbers = parseNumbers(index);
  if (!numbers) return std::nullopt;
  for (unsigned row = 0; row < datumRows().size(); ++row) {
    if (!called(datumRows()[row], name)) continue;
    if (const auto where = complete(datumRows()[row], *numbers)) return Datum{row, *where};
  }
  return std::nullopt;
}

std::string knownData(std::string_view text) {
  const std::string_view name =
      namesDatum(text) ? split(trim(text.substr(kPrefix.size()))).first : text;
  std::string list, before;
  const bool known = knownName(name);
  for (const DatumRow& row : datumRows()) {
    if (known && !called(row, name)) continue;
    if (!known && row.name == before) continue;
    before = row.name;
    list += fmt::format("{}nc.{}", list.empty() ? "" : ", ", row.name);
    if (known && !row.index.empty()) list += fmt::format(" {} ({})", rangeText(row), row.index);
  }
  return list;
}

std::optional<Number> parseDecimal(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  std::string digits(text);
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  if (text.substr(sign).starts_with('.') || text.ends_with('.')) return std::nullopt;
  const std::size_t point = digits.find('.');
  const std::size_t places = point == std::string::npos ? 0 : digits.size() - point - 1;
  if (point != std::string::npos) digits.erase(point, 1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool number =
      digits.size() > sign && error == std::errc() && end == digits.data() + digits.size();
  if (!number || places > kMostPlaces || value < INT32_MIN || value > INT32_MAX)
    return std::nullopt;
  return Number{static_cast<std::int32_t>(value), static_cast<std::uint8_t>(places)};
}

std::string formatDecimal(Number number) {
  const bool negative = number.digits < 0;
  std::string text = std::to_string(negative ? -std::int64_t{number.digits} : number.digits);
  if (text.size() <= number.places) text.insert(0, number.places + 1 - text.size(), '0');
  if (number.places > 0) text.insert(text.size() - number.places, 1, '.');
  return negative ? "-" + text : text;
}

namespace {

// Whether the input resolution has a place for each digit: 0.001 mm or 0.0001 inch.
bool resolves(const Control& control, Number number) {
  const unsigned places = positionPlaces(control.inputSystem);
  const std::int64_t counts = scaled(number, places);
  return makeNumber(counts, places) &&
         (number.places <= places || scaled(counts, places, number.places) == number.digits);
}

}  // namespace

std::string readDatum(const Control& control, const Datum& datum) {
  const auto part = static_cast<unsigned>(datum.where[2] > 0 ? datum.where[2] - 1 : 0);
  const auto number = rowOf(datum).get(control, datum.where, part);
  return number ? formatDecimal(*number) : std::string();
}

bool writeDatum(Control& control, const Datum& datum, Number number) {
  const DatumRow& row = rowOf(datum);
  if (row.put == nullptr) return false;
  if (row.content == Content::Whole) {
    const std::int64_t whole = scaled(number, 0);
    if (scaled(whole, 0, number.places) != number.digits) return false;
    if (whole < row.lowest || whole > row.highest) return false;
    number = {static_cast<std::int32_t>(whole), 0};
  } else if (!makeNumber(number.digits, number.places) || (row.lowest == 0 && number.digits < 0) ||
             (row.content == Content::Position && !resolves(control, number))) {
    return false;
  }
  return row.put(control, datum.where, number);
}

// Tried on a copy: what a datum takes may depend on others.
bool takes(const Control& control, const Datum& datum, std::string_view digits) {
  const auto number = parseDecimal(digits);
  Control copy = control;
  return number && writeDatum(copy, datum, *number);
}

std::string whatItTakes(const Datum& datum) {
  const DatumRow& row = rowOf(datum);
  if (row.put == nullptr) return "it is only read: the NC makes it of others";
  if (row.content == Content::Whole)
    return "it takes whole numbers from " + std::to_string(row.lowest) + " to " +
           std::to_string(row.highest);
  if (row.content == Content::Position)
    return "it takes numbers of at most eight digits with three places (metric) or four (inch)";
  return std::string("it takes numbers of at most eight digits with a point, ") +
         (row.lowest == 0 ? "from 0 on, " : "") + "as 123.456";
}

}  // namespace merker::nc
