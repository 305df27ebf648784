#include "workbench/fields.h"

#include <algorithm>
#include <cmath>

namespace merker::workbench {

const Json* Fields::find(std::string_view key) const {
  const auto found = object_.find(key);
  return found == object_.end() || found->is_null() ? nullptr : &*found;
}

void Fields::wrong(std::string_view key, std::string_view expected) const {
  problems_.add(has(key) ? ProblemCode::P1305 : ProblemCode::P1306, nowhere(), path(key), expected);
}

std::string Fields::text(std::string_view key, std::optional<std::string> otherwise) const {
  const Json* value = find(key);
  if (value != nullptr && value->is_string()) return value->get<std::string>();
  if (value != nullptr || !otherwise) wrong(key, "a text");
  return otherwise.value_or("");
}

std::string Fields::name(std::string_view key, std::size_t most) const {
  std::string value = text(key);
  if (value.size() <= most) return value;
  wrong(key, fmt::format("a text of at most {} bytes", most));
  return {};
}

bool Fields::flag(std::string_view key, std::optional<bool> otherwise) const {
  const Json* value = find(key);
  if (value != nullptr && value->is_boolean()) return value->get<bool>();
  if (value != nullptr || !otherwise) wrong(key, "true or false");
  return otherwise.value_or(false);
}

namespace {

// Whole numbers also where they are written 5.0; beyond 2^53 JSON numbers are not exact.
std::optional<std::int64_t> whole(const Json& value) {
  constexpr double kExact = 9007199254740992.0;
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (!(std::abs(number) <= kExact) || number != std::floor(number)) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

}  // namespace

std::int64_t Fields::integer(std::string_view key, std::int64_t low, std::int64_t high,
                             std::optional<std::int64_t> otherwise) const {
  const Json* value = find(key);
  const auto number = value == nullptr ? std::nullopt : whole(*value);
  if (number && *number >= low && *number <= high) return *number;
  if (value != nullptr || !otherwise)
    wrong(key, fmt::format("a whole number from {} to {}", low, high));
  return otherwise.value_or(low);
}

double Fields::number(std::string_view key, double low, double high,
                      std::optional<double> otherwise) const {
  const Json* value = find(key);
  if (value != nullptr && value->is_number()) {
    const double number = value->get<double>();
    if (number >= low && number <= high) return number;
  }
  if (value != nullptr || !otherwise) wrong(key, fmt::format("a number from {} to {}", low, high));
  return otherwise.value_or(low);
}

std::string Fields::literal(std::string_view key) const {
  constexpr std::size_t kLongest = 4096;
  const auto simple = [](const Json& value) { return value.is_primitive() && !value.is_null(); };
  const Json* value = find(key);
  const bool good = value != nullptr &&
                    (simple(*value) || (value->is_array() && std::ranges::all_of(*value, simple)));
  const std::string text = good ? dump(*value) : std::string();
  if (!good || text.size() > kLongest)
    wrong(key, "a text, a number, true, false or a list of these");
  return text;
}

std::size_t Fields::choice(std::string_view key, std::initializer_list<std::string_view> words,
                           std::optional<std::size_t> otherwise) const {
  const Json* value = find(key);
  if (value != nullptr && value->is_string()) {
    const auto found = std::find(words.begin(), words.end(), value->get_ref<const std::string&>());
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  }
  std::string expected;
  for (const std::string_view word : words)
    expected += fmt::format("{}\"{}\"", expected.empty() ? "" : ", ", word);
  if (value != nullptr || !otherwise) wrong(key, "one of " + expected);
  return otherwise.value_or(0);
}

const Json* Fields::list(std::string_view key, std::size_t most, std::string_view expected) const {
  const Json* value = find(key);
  if (value != nullptr && value->is_array() && value->size() <= most) return value;
  wrong(key, fmt::format("a list of at most {} {}", most, expected));
  return nullptr;
}

Fields Fields::object(std::string_view key) const {
  static const Json kNone = Json::object();
  const Json* value = find(key);
  const bool good = value != nullptr && value->is_object();
  if (!good) wrong(key, "an object");
  return {good ? *value : kNone, problems_, path(key) + "."};
}

std::vector<Fields> Fields::objects(std::string_view key, std::size_t most) const {
  std::vector<Fields> result;
  const Json* value = list(key, most, "objects");
  if (value == nullptr) return result;
  for (std::size_t i = 0; i < value->size(); ++i) {
    const std::string name = fmt::format("{}[{}]", key, i);
    if ((*value)[i].is_object())
      result.emplace_back((*value)[i], problems_, path(name) + ".");
    else
      problems_.add(ProblemCode::P1305, nowhere(), path(name), "an object");
  }
  return result;
}

std::vector<std::string> Fields::texts(std::string_view key, std::size_t most) const {
  std::vector<std::string> result;
  const Json* value = list(key, most, "texts");
  if (value == nullptr) return result;
  for (std::size_t i = 0; i < value->size(); ++i) {
    if ((*value)[i].is_string())
      result.push_back((*value)[i].get<std::string>());
    else
      problems_.add(ProblemCode::P1305, nowhere(), path(fmt::format("{}[{}]", key, i)), "a text");
  }
  return result;
}

std::vector<std::int64_t> Fields::integers(std::string_view key, std::int64_t low,
                                           std::int64_t high, std::size_t most) const {
  std::vector<std::int64_t> result;
  const Json* value = list(key, most, "whole numbers");
  if (value == nullptr) return result;
  for (std::size_t i = 0; i < value->size(); ++i) {
    const auto number = whole((*value)[i]);
    if (number && *number >= low && *number <= high)
      result.push_back(*number);
    else
      problems_.add(ProblemCode::P1305, nowhere(), path(fmt::format("{}[{}]", key, i)),
                    fmt::format("a whole number from {} to {}", low, high));
  }
  return result;
}

}  // namespace merker::workbench
