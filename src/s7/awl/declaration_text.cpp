#include "awl/declaration_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "address/constant.h"
#include "base/bytes.h"

namespace merker::awl {
namespace {

// Equal values one behind the other stand once: 24 (7).
std::string arrayValue(const block::Type& type, std::span<const std::uint8_t> bytes) {
  std::vector<std::pair<std::string, std::size_t>> runs;
  for (const BitAddress offset : block::elementOffsets(type)) {
    if (offset / 8 >= bytes.size()) return {};
    std::string value = valueText(*type.element, bytes.subspan(offset / 8), offset % 8);
    if (value.empty()) return {};
    if (runs.empty() || runs.back().first != value) runs.emplace_back(std::move(value), 0);
    ++runs.back().second;
  }
  std::string text;
  for (const auto& [value, count] : runs)
    text += (text.empty() ? "" : ", ") + (count > 1 ? fmt::format("{} ({})", count, value) : value);
  return text;
}

std::string startValue(const block::Variable& v) {
  if (!v.hasInitial) return {};
  const std::string value = v.type->code == TypeCode::Array ? arrayValue(*v.type, v.initial)
                                                            : valueText(*v.type, v.initial, 0);
  return value.empty() ? value : " := " + value;
}

std::string members(const std::vector<block::Variable>& variables) {
  std::string text = "STRUCT\n";
  for (const block::Variable& v : variables)
    text += fmt::format("    {} : {}{};\n", v.name, typeText(*v.type), startValue(v));
  return text + "  END_STRUCT";
}

struct SectionName {
  block::Section section;
  std::string_view keyword;
};
constexpr SectionName kSections[] = {{block::Section::Input, "VAR_INPUT"},
                                     {block::Section::Output, "VAR_OUTPUT"},
                                     {block::Section::InOut, "VAR_IN_OUT"},
                                     {block::Section::Static, "VAR"},
                                     {block::Section::Temp, "VAR_TEMP"}};

}  // namespace

std::string typeText(const block::Type& type) {
  if (type.code == TypeCode::Struct && type.udt < 0) return members(type.members);
  if (type.code == TypeCode::Array) {
    std::string limits;
    for (const block::Dimension& d : type.dimensions)
      limits += fmt::format("{}{}..{}", limits.empty() ? "" : ",", d.low, d.high);
    return fmt::format("ARRAY [{}] OF {}", limits, typeText(*type.element));
  }
  return toString(type);
}

std::string valueText(const block::Type& type, std::span<const std::uint8_t> bytes, unsigned bit) {
  if (type.code == TypeCode::String) {
    if (bytes.size() < 2) return {};
    const std::size_t length = std::min<std::size_t>(bytes[1], bytes.size() - 2);
    std::string quoted = "'";  // byte by byte: other code pages come through unchanged
    for (const std::uint8_t byte : bytes.subspan(2, length)) {
      if (byte >= 0x80) {
        quoted += fmt::format("${:02X}", byte);
        continue;
      }
      const std::string one = formatCharacters(std::string(1, static_cast<char>(byte)));
      quoted += one.substr(1, one.size() - 2);
    }
    return quoted + "'";
  }
  if (type.code == TypeCode::DateAndTime) {
    std::uint64_t bcd = 0;
    if (bytes.size() < 8) return {};
    for (std::size_t i = 0; i < 8; ++i) bcd = bcd << 8 | bytes[i];
    return formatDateAndTime(bcd);
  }
  if (!isElementary(type.code) || bytes.size() < block::sizeInBytes(type)) return {};
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < block::sizeInBytes(type); ++i) bits = bits << 8 | bytes[i];
  if (type.code == TypeCode::Bool) return (bits >> bit & 1) != 0 ? "TRUE" : "FALSE";
  if (type.code == TypeCode::Real) return formatConstant({ConstantFormat::Real, bits});
  return formatValue(type.code, bits);
}

std::string declarationText(const block::Block& block) {
  if (block.id.kind == BlockKind::DB) return members(block.variables) + ";\n";
  std::string text;
  for (const auto& [section, keyword] : kSections) {
    std::string lines;
    for (const block::Variable& v : block.variables)
      if (v.section == section)
        lines += fmt::format("  {} : {}{};\n", v.name, typeText(*v.type), startValue(v));
    if (!lines.empty()) text += fmt::format("{}\n{}END_VAR\n", keyword, lines);
  }
  return text;
}

}  // namespace merker::awl
