#include "campaign/table.h"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "campaign/schema.h"

namespace merker::campaign {
namespace {

using store::Database;
using store::Statement;

// Numbers in memory; a campaign of a million runs with eight columns has fewer.
constexpr std::size_t kMostCells = 20'000'000;

std::vector<std::string> lines(std::string_view text) {
  std::vector<std::string> list;
  while (!text.empty()) {
    const auto end = text.find('\n');
    list.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return list;
}

Value valueAt(const Statement& row, int column) {
  return row.isText(column) ? Value{row.text(column), {}} : valueOf(row.real(column));
}

std::string selectText(const ResultTable& table) {
  std::string text = "SELECT ";
  for (const std::string& name : table.parameters) text += sqlName(name) + ", ";
  for (const std::string& name : table.measures) text += sqlName(name) + ", ";
  return text + "id FROM run";
}

void readRows(Database& database, ResultTable& table) {
  Statement rows = database.prepare(selectText(table));
  const std::size_t columns = table.parameters.size() + table.measures.size() + 1;
  while (rows.step()) {
    if ((table.rows.size() + 1) * columns > kMostCells)
      throw store::Damage(
          fmt::format("more than {} values are too many for a picture", kMostCells));
    ResultTable::Row& row = table.rows.emplace_back();
    int column = 0;
    for (std::size_t i = 0; i < table.parameters.size(); ++i)
      row.parameters.push_back(valueAt(rows, column++));
    for (std::size_t i = 0; i < table.measures.size(); ++i, ++column)
      row.measures.push_back(rows.isNull(column) ? std::nullopt : std::optional(rows.real(column)));
  }
}

}  // namespace

bool isDatabase(const std::string& path) {
  constexpr std::string_view kMagic = "SQLite format 3";
  std::array<char, kMagic.size()> bytes{};
  std::ifstream in(path, std::ios::binary);
  return in.read(bytes.data(), bytes.size()) &&
         std::string_view(bytes.data(), bytes.size()) == kMagic;
}

Result<ResultTable> readTable(const std::string& path) {
  try {
    Database database(path, kMostColumns);
    database.execute("PRAGMA busy_timeout = 60000");
    if (database.integer("PRAGMA application_id") != kApplicationId)
      return makeProblem(ProblemCode::P0784, Position{path}, path, "it is another SQLite file");
    ResultTable table;
    table.name = property(database, "name");
    table.parameters = lines(property(database, "parameters"));
    table.parameters.emplace_back("seed");
    table.measures = lines(property(database, "measures"));
    readRows(database, table);
    return table;
  } catch (const std::exception& error) {
    return makeProblem(ProblemCode::P0786, Position{path}, error.what());
  }
}

}  // namespace merker::campaign
