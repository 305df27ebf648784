#include "campaign/picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace merker::campaign {
namespace {

// A name of a list; the problem names those that there are.
Result<std::size_t> find(const std::vector<std::string>& names, const std::string& wanted,
                         std::string_view what, const std::string& path) {
  const auto found = std::ranges::find_if(
      names, [&](const std::string& name) { return equalsIgnoreCase(name, wanted); });
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  return makeProblem(ProblemCode::P0787, Position{path}, what, wanted,
                     fmt::format("{}", fmt::join(names, ", ")));
}

// The named parameter, else the first one that has several values and is not `taken`.
Result<std::size_t> parameter(const ResultTable& table, const std::string& wanted,
                              std::optional<std::size_t> taken, const std::string& path) {
  if (!wanted.empty()) return find(table.parameters, wanted, "parameter", path);
  for (std::size_t i = 0; i < table.parameters.size(); ++i) {
    const auto differs = [&](const ResultTable::Row& row) {
      return row.parameters[i] != table.rows.front().parameters[i];
    };
    if (i != taken && std::ranges::any_of(table.rows, differs)) return i;
  }
  return std::size_t{taken == std::size_t{0} && table.parameters.size() > 1 ? 1u : 0u};
}

Result<std::size_t> measure(const ResultTable& table, const std::string& wanted,
                            const std::string& path) {
  if (table.measures.empty())
    return makeProblem(ProblemCode::P0789, Position{path},
                       "they have no measure; [campaign.measure] of the campaign names some");
  if (wanted.empty()) return std::size_t{0};
  return find(table.measures, wanted, "measure", path);
}

// Two axes, or an axis and the curves, are two parameters.
std::optional<Problem> sameTwice(const ResultTable& table, std::size_t one, std::size_t other,
                                 std::string_view options, const std::string& path) {
  if (one != other) return std::nullopt;
  return makeProblem(ProblemCode::P0789, Position{path},
                     fmt::format("{} must be two different parameters, not '{}' twice", options,
                                 table.parameters[one]));
}

Result<std::string> heatMap(const ResultTable& table, const PictureWish& wish,
                            const std::string& title, const std::string& path) {
  const auto value = measure(table, wish.heat, path);
  if (!value) return value.error();
  const auto x = parameter(table, wish.x, {}, path);
  if (!x) return x.error();
  const auto y = parameter(table, wish.y, x.value(), path);
  if (!y) return y.error();
  if (const auto problem = sameTwice(table, x.value(), y.value(), "--x and --y", path))
    return *problem;
  return drawHeatMap(table, {title, x.value(), y.value(), value.value()});
}

Result<std::string> curves(const ResultTable& table, const PictureWish& wish,
                           const std::string& title, const std::string& path) {
  const auto value = measure(table, wish.y, path);
  if (!value) return value.error();
  const auto x = parameter(table, wish.x, {}, path);
  if (!x) return x.error();
  CurveWish curve{title, x.value(), value.value(), {}};
  if (!wish.by.empty()) {
    const auto by = find(table.parameters, wish.by, "parameter", path);
    if (!by) return by.error();
    if (const auto problem = sameTwice(table, x.value(), by.value(), "--x and --by", path))
      return *problem;
    curve.by = by.value();
  }
  return drawQuantiles(table, curve);
}

}  // namespace

Result<std::string> draw(const ResultTable& table, const PictureWish& wish,
                         const std::string& path) {
  if (table.rows.empty())
    return makeProblem(ProblemCode::P0786, Position{path}, "no run is over yet");
  const std::string& title = wish.title.empty() ? table.name : wish.title;
  return wish.heat.empty() ? curves(table, wish, title, path) : heatMap(table, wish, title, path);
}

}  // namespace merker::campaign
