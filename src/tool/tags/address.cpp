#include "tags/address.h"

#include <fmt/format.h>

namespace merker::tags {
namespace {

// Types that travel alike are one row; the words of each tool stand beside each other.
struct TypeRow {
  TypeCode type;
  std::string_view nodeRedData, nodeRed;  // "DB1,REAL4", "MR4"
  std::string_view item;                  // Kepware and Ignition, in all areas: "DB1,DI4", "MDI4"
  std::string_view kepware, ignition;     // data types of their tags
  std::string_view fuxa;
};
using enum TypeCode;
constexpr TypeRow kRows[] = {
    {Bool, "X", "", "X", "Boolean", "Boolean", "Bool"},
    {Byte, "BYTE", "B", "B", "Byte", "Int2", "Byte"},
    {Char, "CHAR", "C", "C", "Char", "Int1", "Byte"},
    {Word, "WORD", "W", "W", "Word", "Int4", "Word"},
    {S5Time, "WORD", "W", "W", "Word", "Int4", "Word"},
    {Date, "WORD", "W", "W", "Word", "Int4", "Word"},
    {Int, "INT", "I", "I", "Short", "Int2", "Int"},
    {DWord, "DWORD", "D", "D", "DWord", "Int8", "DWord"},
    {TimeOfDay, "DWORD", "D", "D", "DWord", "Int8", "DWord"},
    {DInt, "DINT", "DI", "DI", "Long", "Int4", "DInt"},
    {Time, "DINT", "DI", "DI", "Long", "Int4", "DInt"},
    {Real, "REAL", "R", "REAL", "Float", "Float4", "Real"},
    {String, "S", {}, "STRING", "String", "String", {}},
    {DateAndTime, "DT", {}, "DT", {}, "DateTime", {}},  // Kepware's has no type of its own
    // Timers come as milliseconds, counters as numbers; neither has a word in its address.
    {Timer, {}, {}, {}, "Long", "Int4", {}},
    {Counter, {}, {}, {}, "Word", "Int4", {}},
};

template <std::string_view TypeRow::*Column>
std::string_view word(TypeCode type) {
  for (const TypeRow& row : kRows)
    if (row.type == type) return row.*Column;
  return {};
}

struct AreaName {
  TagArea area;
  std::string_view english, german;
};
constexpr AreaName kAreas[] = {{TagArea::Input, "I", "E"},
                               {TagArea::Output, "Q", "A"},
                               {TagArea::Flag, "M", "M"},
                               {TagArea::PeripheralInput, "PI", "PE"},
                               {TagArea::PeripheralOutput, "PQ", "PA"},
                               {TagArea::Data, "DB", "DB"},
                               {TagArea::Timer, "T", "T"},
                               {TagArea::Counter, "C", "Z"}};

std::string_view name(TagArea area, Mnemonics mnemonics = Mnemonics::International) {
  for (const AreaName& row : kAreas)
    if (row.area == area) return mnemonics == Mnemonics::German ? row.german : row.english;
  return {};
}

bool isPeripheral(TagArea area) {
  return area == TagArea::PeripheralInput || area == TagArea::PeripheralOutput;
}

bool isNumbered(TagArea area) { return area == TagArea::Timer || area == TagArea::Counter; }

// ".3" of a bit, ".20" of a string with 20 characters.
std::string behind(const Tag& tag) {
  if (tag.type == Bool) return fmt::format(".{}", tag.at % 8);
  return tag.type == String ? fmt::format(".{}", tag.length) : "";
}

// X, B, W or D.
char widthLetter(TypeCode type) {
  switch (bitWidth(type)) {
    case 1:
      return 'X';
    case 16:
      return 'W';
    case 32:
      return 'D';
    default:
      return 'B';
  }
}

}  // namespace

const Tool kKepware{word<&TypeRow::item>, word<&TypeRow::item>, word<&TypeRow::kepware>, true};
const Tool kIgnition{word<&TypeRow::item>, word<&TypeRow::item>, word<&TypeRow::ignition>, false};
const Tool kNodeRed{word<&TypeRow::nodeRedData>, word<&TypeRow::nodeRed>,
                    [](TypeCode) { return std::string_view("any"); }, true};

std::optional<std::string> address(const Tag& tag, const Tool& tool) {
  if (tool.tagType(tag.type).empty()) return std::nullopt;
  if (isNumbered(tag.area)) return fmt::format("{}{}", name(tag.area), tag.at);
  if (isPeripheral(tag.area) && !(tool.peripherals && tag.readable)) return std::nullopt;
  const bool data = tag.area == TagArea::Data;
  const std::string_view type = data ? tool.inData(tag.type) : tool.elsewhere(tag.type);
  if (type.empty() && (data || tag.type != Bool)) return std::nullopt;
  return fmt::format("{}{}{}{}{}", name(tag.area), data ? fmt::format("{},", tag.db) : "", type,
                     tag.at / 8, behind(tag));
}

std::string step7Address(const Tag& tag, Mnemonics mnemonics) {
  const std::string_view area = name(tag.area, mnemonics);
  if (isNumbered(tag.area)) return fmt::format("{} {}", area, tag.at);
  const char width = widthLetter(tag.type);
  const std::string place =
      tag.type == Bool ? fmt::format("{}.{}", tag.at / 8, tag.at % 8) : std::to_string(tag.at / 8);
  if (tag.area == TagArea::Data) return fmt::format("DB{}.DB{} {}", tag.db, width, place);
  return width == 'X' ? fmt::format("{} {}", area, place)
                      : fmt::format("{}{} {}", area, width, place);
}

std::string_view fuxaType(TypeCode type) { return word<&TypeRow::fuxa>(type); }

}  // namespace merker::tags
