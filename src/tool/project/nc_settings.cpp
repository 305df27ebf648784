// [nc] of merker.toml: what the NC side holds at the start. Its keys are the names of nc/datum.h
// (S5-FM: FB 56 to 58, FB 61, FB 62).
#include <algorithm>

#include "nc/datum.h"
#include "project/numbered_keys.h"
#include "project/readers.h"

namespace merker::project {
namespace {

using nc::Control;
using nc::DatumRow;

constexpr std::string_view kDecimal = "a text of at most eight digits with a point: \"1425.67\"";
constexpr std::string_view kPosition =
    "a whole number of the input resolution (12345), or a text: \"12.345\"";

bool named(const DatumRow& row, std::string_view key) {
  return row.setting && (row.name == key || (!row.alias.empty() && row.alias == key));
}

// The rows of one name, while their numbers are read one after the other.
struct Rows {
  std::vector<unsigned> numbers;
  nc::Where where{};
  unsigned depth = 0;

  const DatumRow& row(std::size_t i) const { return nc::datumRows()[numbers[i]]; }
  unsigned count() const { return nc::indexCount(row(0)); }
  // "1 to 5", "0 to 0, 1 to 2"
  std::string possible() const {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const nc::Limit& limit = row(i).limits.at(depth);
      text += (text.empty() ? "" : ", ") + std::to_string(limit.low);
      if (limit.high > limit.low) text += " to " + std::to_string(limit.high);
    }
    return text + " (" + std::string(row(0).index) + ")";
  }
  std::optional<Rows> at(std::string_view key) const {
    const auto number = keyNumber(key);
    Rows result{{}, where, depth + 1};
    for (std::size_t i = 0; number && i < numbers.size(); ++i) {
      const nc::Limit& limit = row(i).limits.at(depth);
      const auto value = static_cast<int>(std::min<unsigned>(*number, INT32_MAX));
      if (value < limit.low || value > limit.high) continue;
      result.numbers.push_back(numbers[i]);
      result.where.at(depth) = value;
    }
    return result.numbers.empty() ? std::nullopt : std::optional(result);
  }
};

std::optional<nc::Number> whole(const Table& table, std::string_view key, const DatumRow& row) {
  const bool counts = row.content == nc::Content::Position;
  const auto value =
      table.integer(key, counts ? INT32_MIN : row.lowest, counts ? INT32_MAX : row.highest);
  if (!value) return std::nullopt;
  return nc::Number{static_cast<std::int32_t>(*value), 0};
}

std::optional<nc::Number> decimal(const Table& table, std::string_view key, std::string_view form) {
  const auto text = table.text(key, form);
  if (!text) return std::nullopt;
  const auto number = nc::parseDecimal(*text);
  if (!number) table.mustBe(key, form);
  return number;
}

void readValue(const Table& table, const std::string& key, const Rows& rows, Control& control) {
  const nc::Datum datum{rows.numbers.front(), rows.where};
  const DatumRow& row = rows.row(0);
  const bool counts = row.content == nc::Content::Position && table.node(key)->is_integer();
  const bool isWhole = counts || row.content == nc::Content::Whole;
  auto number =
      isWhole ? whole(table, key, row)
              : decimal(table, key, row.content == nc::Content::Position ? kPosition : kDecimal);
  if (!number) return;
  if (counts) number->places = static_cast<std::uint8_t>(positionPlaces(control.inputSystem));
  if (!nc::writeDatum(control, datum, *number))
    table.mustBe(key, isWhole && !counts                     ? nc::whatItTakes(datum)
                      : row.content == nc::Content::Position ? std::string(kPosition)
                                                             : std::string(kDecimal));
}

void readRows(const Table& table, const std::string& key, const Rows& rows, Control& control) {
  const unsigned left = rows.count() - rows.depth;
  const bool isTable = table.node(key)->is_table();
  if (left == 0 || (left == 1 && rows.row(0).last && !isTable)) {
    Rows complete = rows;
    if (left == 1) complete.where.at(rows.depth) = *rows.row(0).last;
    return readValue(table, key, complete, control);
  }
  const auto inner = table.table(key);
  if (!inner) return;
  for (const std::string& number : inner->keys()) {
    if (const auto some = rows.at(number))
      readRows(*inner, number, *some, control);
    else
      unknownKey(*inner, number, rows.possible());
  }
}

std::vector<std::string_view> keys() {
  std::vector<std::string_view> list{"input_system", "alarms", "machining_stop"};
  for (const DatumRow& row : nc::datumRows())
    for (const std::string_view name : {row.name, row.alias})
      if (row.setting && !name.empty() && name != "alarm" &&
          std::find(list.begin(), list.end(), name) == list.end())
        list.push_back(name);
  return list;
}

}  // namespace

void readNc(const Table& table, Control& control) {
  table.allow(keys());
  if (const auto system = table.choice("input_system", {"metric", "inch"}))
    control.inputSystem = *system == 0 ? nc::InputSystem::Metric : nc::InputSystem::Inch;
  for (const Table::Number& alarm : table.numbers("alarms", "numbers of NC alarms"))
    control.raise(static_cast<std::uint16_t>(std::min<std::uint32_t>(alarm.value, 0xFFFF)));
  if (const auto stop = table.flag("machining_stop")) control.machiningStop = *stop;
  for (const std::string& key : table.keys()) {
    Rows rows;
    for (unsigned i = 0; i < nc::datumRows().size(); ++i)
      if (named(nc::datumRows()[i], key)) rows.numbers.push_back(i);
    if (!rows.numbers.empty()) readRows(table, key, rows, control);
  }
}

}  // namespace merker::project
