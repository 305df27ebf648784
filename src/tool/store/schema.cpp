#include "store/schema.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "store/card_file.h"

namespace merker::store {
namespace {

struct Row {
  std::string_view type, name, table, sql;  // as in sqlite_schema
  bool operator==(const Row&) const = default;
};

constexpr std::array kSchema{
    Row{"table", "block", "block",
        "CREATE TABLE block(kind INTEGER, number INTEGER, read_only INTEGER, container BLOB,"
        " checksum INTEGER, PRIMARY KEY(kind, number))"},
    Row{"table", "setting", "setting",
        "CREATE TABLE setting(name TEXT PRIMARY KEY, value BLOB, checksum INTEGER)"},
    Row{"table", "area", "area",
        "CREATE TABLE area(kind TEXT, number INTEGER, length INTEGER, PRIMARY KEY(kind, number))"},
    Row{"table", "page", "page",
        "CREATE TABLE page(kind TEXT, number INTEGER, page INTEGER, bytes BLOB, checksum INTEGER,"
        " PRIMARY KEY(kind, number, page)) WITHOUT ROWID"},
    // Made by SQLite for the primary keys; a table without row numbers is its own index.
    Row{"index", "sqlite_autoindex_block_1", "block", ""},
    Row{"index", "sqlite_autoindex_setting_1", "setting", ""},
    Row{"index", "sqlite_autoindex_area_1", "area", ""}};

}  // namespace

void createTables(Database& database) {
  std::string sql = "PRAGMA page_size = 1024; BEGIN EXCLUSIVE;";
  for (const Row& row : kSchema) sql += row.sql.empty() ? "" : std::string(row.sql) + ";";
  sql += "PRAGMA application_id = " + std::to_string(kApplicationId) +
         "; PRAGMA user_version = " + std::to_string(kFormat) + "; COMMIT;";
  database.execute(sql.c_str());
}

void requireTables(Database& database) {
  Statement select =
      database.prepare("SELECT type, name, tbl_name, ifnull(sql, '') FROM sqlite_schema");
  std::array<bool, kSchema.size()> found{};
  while (select.step()) {
    const std::string type = select.text(0), name = select.text(1), table = select.text(2),
                      sql = select.text(3);
    const auto row = std::find(kSchema.begin(), kSchema.end(), Row{type, name, table, sql});
    if (row == kSchema.end())
      throw Damage("the " + type + " '" + name + "' in it does not belong to a card");
    found[static_cast<std::size_t>(row - kSchema.begin())] = true;
  }
  const auto missing = std::find(found.begin(), found.end(), false);
  if (missing != found.end())
    throw Damage("the table '" +
                 std::string(kSchema[static_cast<std::size_t>(missing - found.begin())].table) +
                 "' is missing or has no index");
}

}  // namespace merker::store
