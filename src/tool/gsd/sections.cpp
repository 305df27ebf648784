// What stands in the sections of a GSD file, and what outside of them is more than a value.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gsd/reader.h"
#include "gsd/values.h"

namespace merker::gsd {
namespace {

bool keywordIsHex(const Statement& s) {
  return s.keyword.starts_with("0x") || s.keyword.starts_with("0X");
}

}  // namespace

void Reader::text(const Statement& s) {
  const auto value = s.index ? number(*s.index) : std::nullopt;
  if (!value) return remark(s.offset, "a text must have its value: Text(1) = \"...\"");
  device_.texts[texts_][*value] = firstText(s);
}

void Reader::textOfParameter(const Statement& s) { device_.definitions.back().text = wanted(s); }

// The reference of the module, or its bytes in a line of their own.
void Reader::bareNumber(const Statement& s) {
  Module& module = device_.modules.back();
  if (!module.configuration.empty() || (s.values.empty() && !keywordIsHex(s))) {
    module.reference = number(s.keyword);
    return;
  }
  Statement list = s;
  list.values.insert(list.values.begin(), {Word::Kind::Plain, s.keyword, s.offset});
  module.configuration = bytes(list, file_, reading_.remarks);
}

void Reader::moduleInfo(const Statement& s) { device_.modules.back().info = firstText(s); }

void Reader::modulePreset(const Statement& s) {
  device_.modules.back().preset = wanted(s).value_or(0) != 0;
}

void Reader::moduleLength(const Statement& s) {
  parameters().length =
      static_cast<std::uint32_t>(std::clamp<std::int64_t>(wanted(s).value_or(0), 0, 244));
}

// Bit(3) 0 0-1, BitArea(4-5) 1 0-3, Unsigned16 150 1-65535
void Reader::parameterType(const Statement& s) {
  Parameter& parameter = device_.definitions.back();
  parameter.type = s.keyword;
  parameter.standard = firstNumber(s).value_or(0);
  parameter.allowed = ranges(s, 1);
  const auto bits = s.index ? range(*s.index) : std::nullopt;
  if (!bits) return;
  if (bits->first < 0 || bits->second > 7 || bits->first > bits->second)
    return remark(s.offset, fmt::format("bits '{}' must be within 0 to 7", *s.index));
  parameter.firstBit = static_cast<std::uint32_t>(bits->first);
  parameter.lastBit = static_cast<std::uint32_t>(bits->second);
}

// Slot(1) = "Slot 1" 3 1-5,8
void Reader::slot(const Statement& s) {
  Slot slot{.number = index(s), .name = firstText(s), .standard = {}, .allowed = {}};
  for (std::size_t i = 0; i < s.values.size(); ++i) {
    if (s.values[i].kind != Word::Kind::Plain) continue;
    slot.standard = number(s.values[i].text);
    slot.allowed = ranges(s, i + 1);
    break;
  }
  device_.slots.push_back(std::move(slot));
}

void Reader::fixed(const Statement& s) {
  parameters().fixed.push_back({index(s), bytes(s, file_, reading_.remarks)});
}

void Reader::reference(const Statement& s) {
  if (const auto parameter = wanted(s)) parameters().references.push_back({index(s), *parameter});
}

void Reader::userData(const Statement& s) {
  device_.parameters.fixed.push_back({0, bytes(s, file_, reading_.remarks)});
}

void Reader::diagnosisBit(const Statement& s) {
  device_.diagnosis.push_back({index(s), index(s), {}, firstText(s)});
}

// Unit_Diag_Area = 0-3
void Reader::diagnosisArea(const Statement& s) { area_ = range(wholeText(s)); }

void Reader::diagnosisValue(const Statement& s) {
  if (!area_ || area_->first < 0 || area_->second > 0xFFFF) return;
  device_.diagnosis.push_back({static_cast<std::uint32_t>(area_->first),
                               static_cast<std::uint32_t>(area_->second), index(s), firstText(s)});
}

bool Reader::inSection(const Statement& s, std::string_view keyword) {
  static constexpr std::array<Row, 23> kRows{{
      {Section::Texts, "TEXT", &Reader::text},
      {Section::Definition, "PRM_TEXT_REF", &Reader::textOfParameter},
      {Section::Definition, "BIT", &Reader::parameterType},
      {Section::Definition, "BITAREA", &Reader::parameterType},
      {Section::Definition, "UNSIGNED8", &Reader::parameterType},
      {Section::Definition, "UNSIGNED16", &Reader::parameterType},
      {Section::Definition, "UNSIGNED32", &Reader::parameterType},
      {Section::Definition, "SIGNED8", &Reader::parameterType},
      {Section::Definition, "SIGNED16", &Reader::parameterType},
      {Section::Definition, "SIGNED32", &Reader::parameterType},
      {Section::Slots, "SLOT", &Reader::slot},
      {Section::Module, "INFO_TEXT", &Reader::moduleInfo},
      {Section::Module, "PRESET", &Reader::modulePreset},
      {Section::Module, "EXT_MODULE_PRM_DATA_LEN", &Reader::moduleLength},
      {Section::Module, "EXT_USER_PRM_DATA_CONST", &Reader::fixed},
      {Section::Module, "EXT_USER_PRM_DATA_REF", &Reader::reference},
      {Section::None, "EXT_USER_PRM_DATA_CONST", &Reader::fixed},
      {Section::None, "EXT_USER_PRM_DATA_REF", &Reader::reference},
      {Section::None, "USER_PRM_DATA", &Reader::userData},
      {Section::None, "UNIT_DIAG_BIT", &Reader::diagnosisBit},
      {Section::None, "UNIT_DIAG_AREA", &Reader::diagnosisArea},
      {Section::None, "VALUE", &Reader::diagnosisValue},
      {Section::None, "UNIT_DIAG_AREA_END", &Reader::diagnosisArea},
  }};
  const auto row = std::ranges::find_if(
      kRows, [&](const Row& one) { return one.section == open_ && one.keyword == keyword; });
  if (row == kRows.end()) return false;
  (this->*row->handler)(s);
  return true;
}

}  // namespace merker::gsd
