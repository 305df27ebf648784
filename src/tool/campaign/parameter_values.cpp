#include "campaign/parameter_values.h"

#include <fmt/format.h>

#include <cmath>

#include "campaign/draw.h"

namespace merker::campaign {
namespace {

using project::Table;

constexpr std::string_view kWhat =
    "a value, a list of values, {from = 0.8, to = 1.2, steps = 9}, {uniform = [0.8, 1.2]} or "
    "{normal = 1.0, sigma = 0.05}";

Position placeOf(const Table& table, const toml::node& node) {
  const auto& begin = node.source().begin;
  return {table.place().file, begin.line, begin.column};
}

// Nothing, and a problem, if it is neither text nor number nor truth value.
std::optional<Value> readValue(const Table& table, const std::string& key, const toml::node& node) {
  if (const auto* text = node.as_string(); text && text->get().size() <= 1000)
    return Value{text->get(), {}};
  if (const auto* flag = node.as_boolean()) return Value{flag->get() ? "true" : "false", {}};
  const auto number = node.is_number() ? node.value<double>() : std::nullopt;
  if (number && std::abs(*number) <= kLargestNumber) return valueOf(*number);
  table.problems().add(ProblemCode::P0704, placeOf(table, node), key,
                       fmt::format("a text, true, false or a number up to {:g}", kLargestNumber));
  return std::nullopt;
}

bool readList(const Table& table, const std::string& key, const toml::array& array,
              Parameter& parameter) {
  if (array.empty() || array.size() > kMostValues) {
    table.mustBe(key, fmt::format("a list of 1 to {} values", kMostValues));
    return false;
  }
  for (const toml::node& node : array)
    if (auto value = readValue(table, key, node))
      parameter.values.push_back({std::move(*value), placeOf(table, node)});
  return parameter.values.size() == array.size();
}

// Both ends are values; each is a decimal number of few digits, on every computer the same.
bool readRange(const Table& range, const std::string& key, Parameter& parameter) {
  range.allow({"from", "to", "steps"});
  const auto from = range.real("from", -kLargestNumber, kLargestNumber);
  const auto to = range.real("to", -kLargestNumber, kLargestNumber);
  const auto steps = range.integer("steps", 2, kMostValues);
  for (const std::string_view part : {"to", "steps"})
    if (!range.has(part))
      range.problems().add(ProblemCode::P0744, range.place(), key, fmt::format("'{}'", part));
  if (!from || !to || !steps) return false;
  for (std::int64_t i = 0; i < *steps; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(*steps - 1);
    parameter.values.push_back({valueOf(shortened(*from + part * (*to - *from))), range.place()});
  }
  return true;
}

bool readUniform(const Table& range, const std::string& key, Parameter& parameter) {
  range.allow({"uniform"});
  const toml::array* ends = range.node("uniform")->as_array();
  const auto end = [&](std::size_t i) { return ends->get(i)->value<double>().value_or(NAN); };
  if (ends != nullptr && ends->size() == 2 && (*ends)[0].is_number() && (*ends)[1].is_number() &&
      std::abs(end(0)) <= kLargestNumber && std::abs(end(1)) <= kLargestNumber && end(0) < end(1)) {
    parameter.draw = Draw{Draw::Kind::Uniform, end(0), end(1)};
    return true;
  }
  range.mustBe("uniform",
               fmt::format("the two ends of '{}', the lower one first: [0.8, 1.2]", key));
  return false;
}

bool readNormal(const Table& range, const std::string& key, Parameter& parameter) {
  range.allow({"normal", "sigma"});
  const auto mean = range.real("normal", -kLargestNumber, kLargestNumber);
  const auto sigma = range.real("sigma", 0, kLargestNumber);
  if (!range.has("sigma"))
    range.problems().add(ProblemCode::P0744, range.place(), key, "'sigma', the standard deviation");
  if (!mean || !sigma) return false;
  parameter.draw = Draw{Draw::Kind::Normal, *mean, *sigma};
  return true;
}

}  // namespace

bool readValues(const Table& table, const std::string& key, Parameter& parameter) {
  const toml::node* node = table.node(key);
  if (const toml::array* array = node->as_array()) return readList(table, key, *array, parameter);
  if (!node->is_table()) {
    if (auto value = readValue(table, key, *node))
      parameter.values.push_back({*value, table.at(key)});
    return !parameter.values.empty();
  }
  const Table range = *table.table(key);
  if (range.has("from")) return readRange(range, key, parameter);
  if (range.has("uniform")) return readUniform(range, key, parameter);
  if (range.has("normal")) return readNormal(range, key, parameter);
  // plant.Vessel.stroke without quotation marks is a table within a table.
  table.problems().add(
      ProblemCode::P0704, table.placeOf(key), key,
      fmt::format("{}; the whole name stands in quotation marks: \"{}.…\"", kWhat, key));
  return false;
}

}  // namespace merker::campaign
