#include "campaign/schema.h"

#include <fmt/format.h>

#include <vector>

namespace merker::campaign {
namespace {

using store::Database;
using store::Statement;

constexpr std::int64_t kFormat = 1;

std::vector<std::string> namesOf(const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  for (const Parameter& one : parameters) names.push_back(one.name);
  return names;
}

std::vector<std::string> namesOf(const std::vector<MeasureText>& measures) {
  std::vector<std::string> names;
  for (const MeasureText& one : measures) names.push_back(one.name);
  return names;
}

std::string joined(const std::vector<std::string>& names, std::string_view between) {
  return fmt::format("{}", fmt::join(names, between));
}

// In the order of insertText.
std::vector<std::string> columns(const Definition& definition) {
  std::vector<std::string> list{"id"};
  for (const std::string& name : namesOf(definition.parameters)) list.push_back(sqlName(name));
  for (const char* name : {"seed", "passed", "message", "seconds", "cycles"})
    list.emplace_back(name);
  for (const std::string& name : namesOf(definition.measures)) list.push_back(sqlName(name));
  return list;
}

// A number stays a number and a text a text: parameters and measures have no type.
std::string createText(const Definition& definition) {
  std::vector<std::string> list = columns(definition);
  list.front() = "id TEXT PRIMARY KEY NOT NULL";
  return fmt::format("CREATE TABLE IF NOT EXISTS run ({}) WITHOUT ROWID", joined(list, ", "));
}

void describeCampaign(Database& database, const Definition& definition) {
  Statement put = database.prepare("INSERT OR IGNORE INTO campaign VALUES (?, ?)");
  const auto add = [&](std::string_view key, const std::string& value) {
    put.bind(key).bind(std::string_view(value)).run();
  };
  add("name", definition.name);
  add("parameters", joined(namesOf(definition.parameters), "\n"));
  add("measures", joined(namesOf(definition.measures), "\n"));
}

bool isEmpty(Database& database) {
  return database.integer("SELECT count(*) FROM sqlite_schema") == 0;
}

// 60 s: others that write to the same file have their turn.
void open(Database& database) { database.execute("PRAGMA busy_timeout = 60000"); }

}  // namespace

std::string property(Database& database, std::string_view key) {
  Statement row = database.prepare("SELECT value FROM campaign WHERE key = ?");
  row.bind(key);
  return row.step() ? row.text(0) : std::string();
}

std::string sqlName(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

std::optional<Problem> checkSchema(Database& database, const std::string& path,
                                   const Definition& definition) {
  open(database);
  if (database.integer("PRAGMA application_id") != kApplicationId)
    return makeProblem(ProblemCode::P0784, Position{path}, path, "it is another SQLite file");
  if (database.integer("PRAGMA user_version") != kFormat)
    return makeProblem(ProblemCode::P0784, Position{path}, path, "another version wrote it");
  for (const auto& [key, names] : {std::pair{"parameters", namesOf(definition.parameters)},
                                   {"measures", namesOf(definition.measures)}})
    if (property(database, key) != joined(names, "\n"))
      return makeProblem(ProblemCode::P0785, Position{path}, path,
                         fmt::format("it has other {}", key));
  return std::nullopt;
}

std::optional<Problem> prepareSchema(Database& database, const std::string& path,
                                     const Definition& definition) {
  open(database);
  if (isEmpty(database)) {
    // Kept apart: rows go to a log, which a killed process leaves whole.
    database.execute("PRAGMA journal_mode = WAL");
    store::Transaction transaction(database);
    database.execute(
        "CREATE TABLE IF NOT EXISTS campaign (key TEXT PRIMARY KEY NOT NULL, value TEXT)");
    database.execute(createText(definition).c_str());
    database.execute(fmt::format("PRAGMA application_id = {}", kApplicationId).c_str());
    database.execute(fmt::format("PRAGMA user_version = {}", kFormat).c_str());
    describeCampaign(database, definition);
    transaction.commit();
  }
  database.execute("PRAGMA synchronous = NORMAL");
  return checkSchema(database, path, definition);
}

std::string insertText(const Definition& definition) {
  const std::vector<std::string> list = columns(definition);
  const std::vector<std::string> marks(list.size(), "?");
  return fmt::format("INSERT OR IGNORE INTO run ({}) VALUES ({})", joined(list, ", "),
                     joined(marks, ", "));
}

std::string findText(const Definition& definition) {
  std::string text = "SELECT passed, message, seconds, cycles";
  for (const MeasureText& measure : definition.measures) text += ", " + sqlName(measure.name);
  return text + " FROM run WHERE id = ?";
}

std::size_t copyRows(Database& from, Database& to, const Definition& definition,
                     const std::set<std::string>& known) {
  const auto count = [&] { return to.integer("SELECT count(*) FROM run"); };
  const std::vector<std::string> list = columns(definition);
  Statement rows = from.prepare(fmt::format("SELECT {} FROM run", joined(list, ", ")));
  Statement insert = to.prepare(insertText(definition));
  store::Transaction transaction(to);
  const std::int64_t before = count();
  while (rows.step()) {
    if (!known.contains(rows.text(0))) continue;
    for (int i = 0; i < static_cast<int>(list.size()); ++i) insert.copy(rows, i);
    insert.run();
  }
  const std::int64_t after = count();
  transaction.commit();
  return static_cast<std::size_t>(after - before);
}

}  // namespace merker::campaign
