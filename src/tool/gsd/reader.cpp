#include "gsd/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.h"
#include "gsd/configuration.h"
#include "gsd/values.h"

namespace merker::gsd {
namespace {

struct SectionRow {
  std::string_view begin, end;
  Section section;
};
constexpr std::array<SectionRow, 8> kSections{{
    {"PrmText", "EndPrmText", Section::Texts},
    {"ExtUserPrmData", "EndExtUserPrmData", Section::Definition},
    {"Module", "EndModule", Section::Module},
    {"SlotDefinition", "EndSlotDefinition", Section::Slots},
    {"UnitDiagType", "EndUnitDiagType", Section::Other},
    {"PrmCommand", "EndPrmCommand", Section::Other},
    {"Physical_Interface", "End_Physical_Interface", Section::Other},
    {"Jokerblock_Type", "EndJokerblock_Type", Section::Other},
}};

auto findRow(std::string_view keyword, std::string_view SectionRow::*name) {
  return std::ranges::find_if(
      kSections, [&](const SectionRow& row) { return equalsIgnoreCase(row.*name, keyword); });
}

}  // namespace

std::optional<std::int64_t> Reader::wanted(const Statement& s) {
  const auto value = firstNumber(s);
  if (!value)
    remark(s.offset, fmt::format("'{}' must be a number, not '{}'", s.keyword, wholeText(s)));
  return value;
}

std::uint32_t Reader::index(const Statement& s) const {
  const auto value = s.index ? number(*s.index) : std::nullopt;
  return value && *value >= 0 && *value <= 0xFFFF ? static_cast<std::uint32_t>(*value) : 0;
}

void Reader::closeOpen() {
  if (open_ == Section::None) return;
  const SectionRow& row = kSections[openRow_];
  remark(openedAt_, fmt::format("there is no {} for it", row.end));
  open_ = Section::None;
}

void Reader::begin(Section section, const Statement& s) {
  if (section == Section::Texts) {
    texts_ = wanted(s).value_or(0);
    device_.texts.try_emplace(texts_);
  } else if (section == Section::Definition) {
    device_.definitions.push_back({.number = wanted(s).value_or(0), .line = lineOf(s)});
    device_.definitions.back().name = firstText(s);
  } else if (section == Section::Module) {
    device_.modules.push_back({.line = lineOf(s)});
    device_.modules.back().name = firstText(s);
    device_.modules.back().configuration = bytes(s, file_, reading_.remarks);
  }
}

bool Reader::opens(const Statement& s, std::string_view keyword) {
  const auto row = findRow(keyword, &SectionRow::begin);
  if (row == kSections.end()) return false;
  closeOpen();
  open_ = row->section;
  openRow_ = static_cast<std::size_t>(row - kSections.begin());
  openedAt_ = s.offset;
  begin(open_, s);
  return true;
}

bool Reader::ends(const Statement& s, std::string_view keyword) {
  const auto row = findRow(keyword, &SectionRow::end);
  if (row == kSections.end()) return false;
  if (open_ != Section::None && row->end == kSections[openRow_].end) {
    open_ = Section::None;
  } else {
    remark(s.offset, fmt::format("{} ends nothing that is open", s.keyword));
  }
  return true;
}

void Reader::read(const Statement& s) {
  const std::string keyword = upper(s.keyword);
  if (opens(s, keyword) || ends(s, keyword) || inSection(s, keyword)) return;
  if (open_ == Section::Module && !s.assigns && !s.index && number(s.keyword)) return bareNumber(s);
  if (open_ == Section::Module || inDevice(s, keyword)) return;
  if (open_ == Section::None && s.assigns) {
    std::string key = s.keyword + (s.index ? "(" + *s.index + ")" : "");
    device_.others.insert_or_assign(std::move(key), firstText(s));
  }
}

void Reader::checkReferences(const UserParameters& used, std::uint32_t line) {
  for (const auto& reference : used.references)
    if (std::ranges::find(device_.definitions, reference.parameter, &Parameter::number) ==
        device_.definitions.end())
      reading_.remarks.push_back(
          {line, 0, fmt::format("ExtUserPrmData {} is not defined", reference.parameter)});
}

// What only the whole file shows.
void Reader::finish() {
  closeOpen();
  const auto add = [&](std::uint32_t line, std::string text) {
    reading_.remarks.push_back({line, 0, std::move(text)});
  };
  checkReferences(device_.parameters, 0);
  for (const Parameter& parameter : device_.definitions)
    if (parameter.text && !device_.texts.contains(*parameter.text))
      add(parameter.line, fmt::format("PrmText {} is not defined", *parameter.text));
  for (const Module& module : device_.modules) {
    checkReferences(module.parameters, module.line);
    const Areas areas = readIdentifiers(module.configuration);
    if (!areas.wrong.empty())
      add(module.line,
          fmt::format("the configuration bytes of '{}' are invalid: {}", module.name, areas.wrong));
  }
  if (device_.vendor.empty()) add(0, "Vendor_Name is missing");
  if (device_.ident == 0) add(0, "Ident_Number is missing");
}

}  // namespace merker::gsd
