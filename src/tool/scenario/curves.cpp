#include "scenario/curves.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "address/constant.h"
#include "base/bcd.h"
#include "base/text.h"

namespace merker::simulator {
namespace {

// The next field of a line of CSV, taken off; quotation marks are doubled inside of quoted ones.
std::string takeField(std::string_view& line) {
  std::string field;
  bool quoted = false;
  std::size_t i = 0;
  for (; i < line.size() && (quoted || line[i] != ','); ++i) {
    if (line[i] != '"') {
      field += line[i];
    } else if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
      field += line[i++];
    } else {
      quoted = !quoted;
    }
  }
  line.remove_prefix(std::min(i + 1, line.size()));
  return field;
}

std::optional<double> decimal(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Texts, characters and dates, as a trace writes them, have no place in a picture.
bool isText(std::string_view value) {
  if (value.starts_with('\'') || parseConstant(value, Position{})) return true;
  return upper(value).starts_with("DT#");
}

// As a source writes it: 5, 2.050000e+001, W#16#00FF, T#1S; nothing for texts and dates.
std::optional<double> numberOf(const std::string& text) {
  if (const auto plain = decimal(text)) return plain;
  const auto constant = parseConstant(text, Position{});
  if (!constant) return std::nullopt;
  const std::uint32_t bits = constant.value().bits;
  switch (constant.value().format) {
    case ConstantFormat::Real:
      return double{std::bit_cast<float>(bits)};
    case ConstantFormat::Time:
      return static_cast<std::int32_t>(bits) / 1000.0;
    case ConstantFormat::S5Time:
      return static_cast<double>(decodeS5Time(static_cast<std::uint16_t>(bits)).value_or(0)) / 1000;
    case ConstantFormat::Counter:
      return fromBcd(bits & 0xFFF, 3).value_or(0);
    case ConstantFormat::Integer:
      return static_cast<std::int16_t>(bits);
    case ConstantFormat::LongInteger:
      return static_cast<std::int32_t>(bits);
    case ConstantFormat::Byte:
    case ConstantFormat::Word:
    case ConstantFormat::DWord:
      return bits;
    case ConstantFormat::Boolean:
    case ConstantFormat::Binary:
    case ConstantFormat::LongBinary:
    case ConstantFormat::Characters:
    case ConstantFormat::LongCharacters:
    case ConstantFormat::Bytes:
    case ConstantFormat::LongBytes:
    case ConstantFormat::Date:
    case ConstantFormat::TimeOfDay:
    case ConstantFormat::Pointer:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Curve> readCurves(const source::SourceFile& file, Problems& problems) {
  std::vector<Curve> curves;
  std::map<std::string, std::size_t> places;
  double latest = 0;
  for (std::uint32_t number = 1; number <= file.lineCount(); ++number) {
    std::string_view line = trim(file.line(number));
    if (line.empty()) continue;
    const auto seconds = decimal(takeField(line));
    const std::string operand = takeField(line);
    const auto column = static_cast<std::uint32_t>(line.data() - file.line(number).data()) + 1;
    const std::string value = takeField(line);
    const bool inOrder = seconds && std::isfinite(*seconds) && *seconds >= latest;
    if (!inOrder || operand.empty() || value.empty()) {
      problems.add(ProblemCode::P0990, Position{file.name(), number, 1});
      return curves;
    }
    latest = *seconds;
    const auto is = numberOf(value);
    if (!is && !isText(value)) {
      problems.add(ProblemCode::P0990, Position{file.name(), number, column});
      return curves;
    }
    if (!is) continue;
    const auto [place, fresh] = places.emplace(operand, curves.size());
    if (fresh) curves.push_back({operand, true, {}});
    Curve& curve = curves[place->second];
    curve.binary = curve.binary && (value == "0" || value == "1");
    curve.changes.push_back({*seconds, *is});
  }
  if (curves.empty()) problems.add(ProblemCode::P0992, Position{file.name()});
  return curves;
}

}  // namespace merker::simulator
