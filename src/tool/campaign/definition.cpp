#include "campaign/definition.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/text.h"
#include "campaign/parameter_values.h"
#include "check/relation.h"
#include "project/parse.h"
#include "scenario/duration.h"

namespace merker::campaign {
namespace {

using project::Table;

// Columns of the table of results that every campaign has (results.h).
constexpr std::string_view kColumns[] = {"id", "seed", "passed", "message", "seconds", "cycles"};

std::optional<Duration> duration(const Table& table, std::string_view key) {
  constexpr std::string_view kWhat = "a duration: \"250ms\", \"7.5s\", \"2m\", \"1h\"";
  const auto text = table.text(key, kWhat);
  if (!text) return std::nullopt;
  const auto time = simulator::parseDuration(*text);
  if (time && time->ns > 0) return time;
  table.mustBe(key, kWhat);
  return std::nullopt;
}

// Names of columns, which SQLite compares without regard to case.
class Names {
 public:
  explicit Names(Problems& problems) : problems_(problems) {
    for (const std::string_view column : kColumns) used_.insert(upper(column));
  }
  bool add(const Table& table, const std::string& name) {
    if (name.size() > kLongestName)
      problems_.add(ProblemCode::P0704, table.placeOf(name), name.substr(0, kLongestName),
                    fmt::format("a name of at most {} characters", kLongestName));
    else if (std::ranges::any_of(name, [](unsigned char c) { return c < 0x20; }))
      problems_.add(ProblemCode::P0704, table.placeOf(name), "a name",
                    "a text without control characters");
    else if (!used_.insert(upper(name)).second)
      problems_.add(ProblemCode::P0742, table.placeOf(name), name,
                    "another column of the results, in upper or lower case");
    else
      return true;
    return false;
  }

 private:
  Problems& problems_;
  std::set<std::string> used_;
};

bool isWord(std::string_view name) {
  return !name.empty() && (name[0] < '0' || name[0] > '9') &&
         name.find_first_not_of(
             "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_") ==
             std::string_view::npos;
}

bool few(const Table& table, std::size_t most, std::string_view what) {
  if (table.keys().size() <= most) return true;
  table.problems().add(ProblemCode::P0704, table.place(), table.title(),
                       fmt::format("a table of at most {} {}", most, what));
  return false;
}

void readParameters(const Table& table, Names& names, Definition& definition) {
  if (!few(table, kMostParameters, "parameters")) return;
  for (const std::string& key : table.keys()) {
    if (!names.add(table, key)) continue;
    Parameter parameter{key, table.placeOf(key), {}, {}};
    if (!readValues(table, key, parameter)) continue;
    if (parameter.draw && definition.repeat == 0)
      table.problems().add(ProblemCode::P0744, table.at(key), key,
                           "'repeat', the number of values that are drawn");
    definition.parameters.push_back(std::move(parameter));
  }
}

void readMeasures(const Table& table, Names& names, Definition& definition) {
  if (!few(table, kMostMeasures, "measures")) return;
  for (const std::string& key : table.keys()) {
    if (!isWord(key))
      table.problems().add(ProblemCode::P0704, table.placeOf(key), key,
                           "a word of letters, digits and _, the name of a column");
    else if (names.add(table, key))
      if (const auto text = table.text(key, "a text: \"max plant Vessel.LEVEL\""))
        definition.measures.push_back({key, *text, table.at(key), {}});
  }
}

std::optional<MeasureText::Requirement> requirement(std::string_view text) {
  text = trim(text);
  const block::RelationSign* sign = block::relationAt(text);
  if (sign == nullptr) return std::nullopt;
  const std::string_view digits = trim(text.substr(sign->text.size()));
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
    return std::nullopt;
  return MeasureText::Requirement{sign->relation, value, std::string(text)};
}

void readRequirements(const Table& table, Definition& definition) {
  std::vector<std::string_view> known;
  for (const MeasureText& measure : definition.measures) known.push_back(measure.name);
  table.allow(known);
  constexpr std::string_view kWhat = "a comparison with a number: \"<= 95\"";
  for (MeasureText& measure : definition.measures) {
    const auto text = table.text(measure.name, kWhat);
    if (!text) continue;
    measure.required = requirement(*text);
    if (!measure.required) table.mustBe(measure.name, kWhat);
  }
}

void readScenario(const Table& table, Definition& definition) {
  const auto name = table.text("scenario_name", "a text that the scenario's name contains");
  if (const auto file = table.text("scenario", "a file of scenarios: \"fill.scn\""))
    definition.scenario = ScenarioText{*file, name.value_or(""), table.at("scenario")};
  else if (name)
    table.problems().add(ProblemCode::P0744, table.at("scenario_name"), "scenario_name",
                         "'scenario', the file that it stands in");
}

void readTimes(const Table& table, Definition& definition) {
  definition.time = duration(table, "for");
  definition.start = duration(table, "start");
  const bool hasScenario =
      definition.scenario || (table.table("vary") && table.table("vary")->has("scenario.file"));
  if (!hasScenario && !table.has("for"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "'for', the time of a run, or 'scenario', the file that it follows");
  if (hasScenario && definition.start)
    table.problems().add(ProblemCode::P0744, table.at("start"), "start",
                         "'for' without a scenario, which starts the CPU itself");
}

void readLimits(const Table& table, Definition& definition) {
  definition.repeat = static_cast<std::uint64_t>(
      table.integer("repeat", 1, static_cast<std::int64_t>(kMostRuns), "seeds").value_or(0));
  constexpr std::int64_t kLastSeed = 1'000'000'000;
  definition.firstSeed =
      static_cast<std::uint64_t>(table.integer("first_seed", 0, kLastSeed).value_or(1));
  definition.timeLimit = table.length("time_limit", Duration::seconds(1), Duration::seconds(86'400))
                             .value_or(definition.timeLimit);
  definition.memoryLimit =
      table.number("memory_limit", 16, 65'536, "MB").value_or(definition.memoryLimit);
}

void readCampaign(const Table& table, Definition& definition) {
  table.allow({"name", "project", "scenario", "scenario_name", "for", "start", "repeat",
               "first_seed", "time_limit", "memory_limit", "vary", "measure", "require"});
  definition.name = table.text("name", "a text").value_or(definition.name);
  definition.project = table.text("project", "the folder of a project").value_or(".");
  definition.projectPosition = table.at("project");
  readScenario(table, definition);
  readTimes(table, definition);
  readLimits(table, definition);
  Names names(table.problems());
  if (const auto vary = table.table("vary")) readParameters(*vary, names, definition);
  if (const auto measure = table.table("measure")) readMeasures(*measure, names, definition);
  if (const auto require = table.table("require")) readRequirements(*require, definition);
  const std::uint64_t runs = definition.runs();
  if (runs > kMostRuns) table.problems().add(ProblemCode::P0782, table.place(), kMostRuns);
}

}  // namespace

Value valueOf(double number) { return {fmt::format("{}", number), number}; }

std::uint64_t Definition::runs() const {
  std::uint64_t count = std::max<std::uint64_t>(repeat, 1);
  for (const Parameter& parameter : parameters)
    if (!parameter.draw && count <= kMostRuns) count *= parameter.values.size();
  return count;
}

Definition readDefinition(const source::SourceFile& file, Problems& problems) {
  Definition definition;
  const std::filesystem::path path = file.name();
  definition.file = file.name();
  definition.folder = path.parent_path().empty() ? "." : path.parent_path().string();
  definition.name = path.stem().string();
  const auto toml = project::parseToml(file, problems);
  if (!toml) return definition;
  const Table root(*toml, "", Position{file.name(), 1, 1}, problems);
  root.allow({"campaign"});
  if (const auto campaign = root.table("campaign"))
    readCampaign(*campaign, definition);
  else if (!root.has("campaign"))
    problems.add(ProblemCode::P0744, root.place(), file.name(), "a table [campaign]");
  return definition;
}

}  // namespace merker::campaign
