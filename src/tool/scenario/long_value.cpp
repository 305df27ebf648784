#include "scenario/long_value.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "check/relation.h"

namespace merker::simulator {
namespace {

constexpr std::size_t kHeader = 2;        // of a STRING: longest and present length (S7-TYPES-19)
constexpr unsigned char kCentury = 0x90;  // BCD years from 90 on are those of 1900 (S7-TYPES-18)

using Bytes = std::vector<std::uint8_t>;

std::uint64_t number(const std::string& dateAndTime) {
  std::uint64_t bcd = 0;
  for (const char c : dateAndTime) bcd = bcd << 8 | static_cast<unsigned char>(c);
  return bcd;
}

std::string bytes(std::uint64_t bcd) {
  std::string text(8, '\0');
  for (std::size_t i = 0; i < 8; ++i) text[i] = static_cast<char>(bcd >> (56 - 8 * i));
  return text;
}

constexpr std::size_t kPlaces = 8;  // behind the point of a number of the NC

bool isDecimal(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const auto point = text.find('.');
  const std::string_view before = text.substr(0, point);
  const std::string_view behind =
      point == std::string_view::npos ? std::string_view() : text.substr(point + 1);
  const auto digits = [](std::string_view part) {
    return part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const bool enough = !before.empty() && (point == std::string_view::npos || !behind.empty());
  return enough && digits(before) && digits(behind) && before.size() <= 10 &&
         behind.size() <= kPlaces;
}

// Equal numbers have equal texts, greater ones greater texts.
std::string decimalKey(std::string_view text) {
  if (!isDecimal(text)) return {};
  std::string digits;
  std::size_t places = 0;
  bool behind = false;
  for (const char c : text) {
    behind |= c == '.';
    if (c < '0' || c > '9') continue;
    digits += c;
    places += behind ? 1 : 0;
  }
  digits.append(kPlaces - places, '0');
  const auto value = std::stoll(digits) * (text.starts_with('-') ? -1 : 1);
  return fmt::format("{:020}", static_cast<std::uint64_t>(value) + (std::uint64_t{1} << 63));
}

// What orders two values of the type.
std::string key(TypeCode type, std::string content) {
  if (type == TypeCode::Void) return decimalKey(content);
  if (type != TypeCode::DateAndTime || content.size() != 8) return content;
  content[7] = static_cast<char>(content[7] & 0xF0);  // without the weekday
  return (static_cast<unsigned char>(content[0]) >= kCentury ? '0' : '1') + content;
}

TypeCode typeOf(const Term& left, const Term& right) {
  return left.content ? right.reference.type : left.reference.type;
}

bool isLikeConstant(TypeCode type, std::string_view text) {
  if (type == TypeCode::String) return text.starts_with('\'');
  const std::string word = upper(text.substr(0, text.find('#')));
  return word == "DT" || word == "DATE_AND_TIME";
}

}  // namespace

std::optional<std::string> readLong(const address::Reference& reference,
                                    const controller::Controller& plc) {
  const auto read = plc.readBytes(reference);
  if (!read) return std::nullopt;
  const std::string all(read->begin(), read->end());
  if (reference.nc != 0 && all.empty()) return std::nullopt;
  if (reference.type != TypeCode::String) return all;
  return all.substr(kHeader, (*read)[1]);
}

std::optional<std::string> longValue(const Term& term, const controller::Controller& plc) {
  return term.content ? term.content : readLong(term.reference, plc);
}

bool writeLong(const address::Reference& reference, const std::string& content,
               controller::Controller& plc) {
  if (reference.nc != 0) {
    const Bytes digits(content.begin(), content.end());
    return plc.writeBytes(reference, digits);
  }
  auto all = plc.readBytes(reference);
  if (!all) return false;
  const bool string = reference.type == TypeCode::String;
  const std::size_t first = string ? kHeader : 0;
  if (content.size() > all->size() - first) return false;
  if (string) {
    (*all)[0] = static_cast<std::uint8_t>(all->size() - kHeader);
    (*all)[1] = static_cast<std::uint8_t>(content.size());
  }
  std::copy(content.begin(), content.end(), all->begin() + static_cast<std::ptrdiff_t>(first));
  return plc.writeBytes(reference, *all);
}

std::string formatLong(TypeCode type, const std::string& content) {
  if (type == TypeCode::Void) return content;
  return type == TypeCode::String ? formatCharacters(content) : formatDateAndTime(number(content));
}

std::string plainLong(TypeCode type, const std::string& content) {
  return type == TypeCode::String ? toUtf8(content, Encoding::Cp1252) : formatLong(type, content);
}

Problem otherNotation(const address::Reference& reference, const Position& at) {
  if (reference.nc != 0)
    return makeProblem(ProblemCode::P0960, at, reference.text, "number of the NC",
                       "with digits and a point: 12.345");
  const bool string = reference.type == TypeCode::String;
  return makeProblem(ProblemCode::P0960, at, reference.text, name(reference.type),
                     string ? "'text'" : "DT#1994-01-01-00:00:00.000");
}

Result<std::string> parseLong(std::string_view text, const address::Reference& reference,
                              const Position& at) {
  if (reference.nc != 0 && isDecimal(text)) return std::string(text);
  if (reference.nc != 0) return otherNotation(reference, at);
  if (!isLikeConstant(reference.type, text)) return otherNotation(reference, at);
  if (reference.type == TypeCode::String) return parseCharacters(text, at);
  const auto bcd = parseDateAndTime(text, at);
  if (!bcd) return bcd.error();
  return bytes(bcd.value());
}

bool longHolds(const Term& left, block::Relation relation, const Term& right,
               const controller::Controller& plc) {
  const auto a = longValue(left, plc), b = longValue(right, plc);
  const TypeCode type = typeOf(left, right);
  if (a && b && type == TypeCode::Void && relation == block::Relation::About)
    return isDecimal(*a) && isDecimal(*b) && block::about(std::stod(*a), std::stod(*b));
  return a && b && block::relates(key(type, *a), relation, key(type, *b));
}

std::string actualLong(const Term& left, const Term& right, const controller::Controller& plc) {
  const auto a = longValue(left, plc), b = longValue(right, plc);
  if (!a || !b) return fmt::format("not there: {} does not exist", (a ? right : left).text);
  const TypeCode type = typeOf(left, right);
  const std::string text = formatLong(type, *a);
  if (right.content) return text;
  return fmt::format("{}, {} is {}", text, right.text, formatLong(type, *b));
}

}  // namespace merker::simulator
