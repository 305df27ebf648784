#include "project/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "io/amount.h"

namespace merker::project {
namespace {

template <typename Words>
std::string list(const Words& words, std::string_view quote = "") {
  std::string text;
  for (const std::string_view word : words)
    text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", quote, word, quote);
  return text;
}

}  // namespace

Position Table::position(const toml::source_region& region, std::size_t length) const {
  return {place_.file, region.begin.line, region.begin.column, static_cast<std::uint32_t>(length)};
}

Position Table::valuePosition(const toml::node& node) const {
  const auto& region = node.source();
  const bool oneLine =
      region.end.line == region.begin.line && region.end.column > region.begin.column;
  return position(region, oneLine ? region.end.column - region.begin.column : 1);
}

Position Table::at(std::string_view key) const {
  const toml::node* value = table_.get(key);
  return value == nullptr ? place_ : valuePosition(*value);
}

Position Table::placeOf(std::string_view key) const {
  for (const auto& [name, value] : table_)
    if (name.str() == key) return position(name.source(), key.size());
  return place_;
}

std::string Table::titleOf(std::string_view key) const {
  std::string_view outer = title_;  // "[cpu]", "[[module]]"
  outer.remove_prefix(std::min(outer.find_first_not_of('['), outer.size()));
  outer = outer.substr(0, outer.find(']'));
  return outer.empty() ? fmt::format("[{}]", key) : fmt::format("[{}.{}]", outer, key);
}

void Table::mustBe(std::string_view key, std::string_view what) const {
  problems_.add(ProblemCode::P0704, at(key), key, what);
}

bool Table::allow(const std::vector<std::string_view>& known) const {
  bool good = true;
  for (const auto& [key, value] : table_)
    if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
      good = false;
      problems_.add(ProblemCode::P0703, position(key.source(), key.str().size()), key.str(),
                    title_.empty() ? place_.file : title_, list(known));
    }
  return good;
}

std::vector<std::string> Table::keys() const {
  std::vector<std::pair<toml::source_position, std::string>> found;
  for (const auto& [key, value] : table_) found.emplace_back(key.source().begin, key.str());
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [place, name] : found) names.push_back(std::move(name));
  return names;
}

std::optional<std::string> Table::text(std::string_view key, std::string_view what) const {
  const toml::node* value = table_.get(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* string = value->as_string()) return string->get();
  mustBe(key, what);
  return std::nullopt;
}

std::optional<bool> Table::flag(std::string_view key) const {
  const toml::node* value = table_.get(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* boolean = value->as_boolean()) return boolean->get();
  mustBe(key, "true or false");
  return std::nullopt;
}

std::optional<std::int64_t> Table::integer(std::string_view key, std::int64_t low,
                                           std::int64_t high, std::string_view unit) const {
  const toml::node* value = table_.get(key);
  if (value == nullptr) return std::nullopt;
  const auto* integer = value->as_integer();
  if (integer != nullptr && integer->get() >= low && integer->get() <= high) return integer->get();
  mustBe(key,
         fmt::format("a whole number from {} to {}{}{}", low, high, unit.empty() ? "" : " ", unit));
  return std::nullopt;
}

std::optional<std::uint32_t> Table::number(std::string_view key, std::int64_t low,
                                           std::int64_t high, std::string_view unit) const {
  const auto value = integer(key, low, high, unit);
  return value ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

std::optional<double> Table::real(std::string_view key, double low, double high) const {
  const toml::node* value = table_.get(key);
  if (value == nullptr) return std::nullopt;
  const auto number = value->is_number() ? value->value<double>() : std::nullopt;
  if (number && *number >= low && *number <= high) return number;
  mustBe(key, fmt::format("a number from {:g} to {:g}", low, high));
  return std::nullopt;
}

std::optional<Duration> Table::length(std::string_view key, Duration low, Duration high) const {
  const toml::node* value = table_.get(key);
  if (value == nullptr) return std::nullopt;
  const auto* string = value->as_string();
  const auto length = string == nullptr ? std::nullopt : io::parseLength(string->get());
  if (length && *length >= low && *length <= high) return length;
  mustBe(key, fmt::format("a duration from \"{}\" to \"{}\"", io::formatLength(low),
                          io::formatLength(high)));
  return std::nullopt;
}

std::optional<std::uint32_t> Table::milliseconds(std::string_view key, std::uint32_t low,
                                                 std::uint32_t high) const {
  constexpr std::int64_t kMillisecond = Duration::milliseconds(1).ns;
  const auto time = length(key, Duration::milliseconds(low), Duration::milliseconds(high));
  if (!time) return std::nullopt;
  if (time->ns % kMillisecond == 0) return static_cast<std::uint32_t>(time->ns / kMillisecond);
  mustBe(key, "a whole number of milliseconds");
  return std::nullopt;
}

std::optional<std::size_t> Table::choice(std::string_view key,
                                         std::initializer_list<std::string_view> words) const {
  const std::string what = "one of " + list(words, "\"");
  const auto value = text(key, what);
  if (!value) return std::nullopt;
  const auto found = std::find_if(words.begin(), words.end(), [&](std::string_view word) {
    return equalsIgnoreCase(word, *value);
  });
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  mustBe(key, what);
  return std::nullopt;
}

std::vector<Table::Number> Table::numbers(std::string_view key, std::string_view what) const {
  std::vector<Number> found;
  const auto add = [&](const toml::node& node) {
    const auto* integer = node.as_integer();
    if (integer != nullptr && integer->get() >= 0 && integer->get() <= 65'535)
      found.push_back({static_cast<std::uint32_t>(integer->get()), valuePosition(node)});
    else
      problems_.add(ProblemCode::P0704, valuePosition(node), key, what);
  };
  const toml::node* value = table_.get(key);
  if (value == nullptr) return found;
  if (const toml::array* array = value->as_array())
    for (const toml::node& element : *array) add(element);
  else
    add(*value);
  return found;
}

std::optional<std::vector<Table::Text>> Table::texts(std::string_view key,
                                                     std::string_view what) const {
  const toml::node* value = table_.get(key);
  if (value == nullptr) return std::nullopt;
  const toml::array* array = value->as_array();
  if (array == nullptr) {
    mustBe(key, what);
    return std::nullopt;
  }
  std::vector<Text> found;
  for (const toml::node& element : *array)
    if (const auto* string = element.as_string())
      found.push_back({string->get(), valuePosition(element)});
    else
      problems_.add(ProblemCode::P0704, valuePosition(element), key, what);
  return found;
}

std::optional<Table> Table::table(std::string_view key) const {
  const toml::node* value = table_.get(key);
  if (value == nullptr) return std::nullopt;
  if (const toml::table* table = value->as_table())
    return Table(*table, titleOf(key), placeOf(key), problems_);
  problems_.add(ProblemCode::P0704, placeOf(key), key, fmt::format("a table: {}", titleOf(key)));
  return std::nullopt;
}

std::vector<Table> Table::tables(std::string_view key, std::size_t most) const {
  std::vector<Table> found;
  const toml::node* value = table_.get(key);
  if (value == nullptr) return found;
  const std::string title = fmt::format("[{}]", titleOf(key));
  const toml::array* array = value->as_array();
  const bool good = array != nullptr && std::all_of(array->begin(), array->end(),
                                                    [](const auto& e) { return e.is_table(); });
  if (!good) {
    problems_.add(ProblemCode::P0704, placeOf(key), key,
                  fmt::format("a list of tables: {}", title));
    return found;
  }
  for (const toml::node& element : *array) {
    if (found.size() == most) {
      problems_.add(ProblemCode::P0106, position(element.source()), most, title);
      break;
    }
    found.emplace_back(*element.as_table(), title, position(element.source()), problems_);
  }
  return found;
}

}  // namespace merker::project
