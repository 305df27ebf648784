#include "store/database.h"

#include <array>
#include <utility>

namespace merker::store {
namespace {

[[noreturn]] void fail(sqlite3* database, int code) {
  throw DatabaseError(code & 0xFF,
                      database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code));
}

}  // namespace

Statement::Statement(sqlite3* database, std::string_view sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(database, sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  statement_.reset(statement);
  check(code);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(database_, code);
}

Statement& Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), next_++, value));
  return *this;
}

Statement& Statement::bindReal(double value) {
  check(sqlite3_bind_double(statement_.get(), next_++, value));
  return *this;
}

Statement& Statement::bindNull() {
  check(sqlite3_bind_null(statement_.get(), next_++));
  return *this;
}

Statement& Statement::copy(const Statement& row, int column) {
  check(sqlite3_bind_value(statement_.get(), next_++,
                           sqlite3_column_value(row.statement_.get(), column)));
  return *this;
}

Statement& Statement::bind(std::string_view text) {
  check(sqlite3_bind_text(statement_.get(), next_++, text.data(), static_cast<int>(text.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(std::span<const std::uint8_t> bytes) {
  // A null pointer would be NULL, not an empty blob.
  const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
  check(sqlite3_bind_blob(statement_.get(), next_++, data, static_cast<int>(bytes.size()),
                          SQLITE_STATIC));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  next_ = 1;
  const int reset = sqlite3_reset(statement_.get());
  if (code != SQLITE_DONE) fail(database_, code);
  check(reset);
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

void Statement::require(int column, int type) const {
  if (sqlite3_column_type(statement_.get(), column) != type)
    throw Damage(std::string("a value has the wrong type: ") +
                 sqlite3_column_name(statement_.get(), column));
}

std::int64_t Statement::integer(int column) const {
  require(column, SQLITE_INTEGER);
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_INTEGER)
    require(column, SQLITE_FLOAT);
  return sqlite3_column_double(statement_.get(), column);
}

bool Statement::isNull(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

bool Statement::isText(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_TEXT;
}

std::string Statement::text(int column) const {
  require(column, SQLITE_TEXT);
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr
             ? std::string()
             : std::string(
                   text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

std::vector<std::uint8_t> Statement::bytes(int column) const {
  require(column, SQLITE_BLOB);
  const auto* data =
      static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_.get(), column));
  if (data == nullptr) return {};
  return {data, data + sqlite3_column_bytes(statement_.get(), column)};
}

// A file from somebody else: no tricks of its schema, nothing larger than a card has.
void Database::protect(int columns) {
  sqlite3* const handle = handle_.get();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  for (const int feature :
       {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_TRIGGER,
        SQLITE_DBCONFIG_DQS_DDL, SQLITE_DBCONFIG_DQS_DML})
    sqlite3_db_config(handle, feature, 0, nullptr);
  constexpr int kStatement = 10'000, kPerColumn = 100;
  const std::array kLimits{std::pair{SQLITE_LIMIT_LENGTH, 4 * 1024 * 1024},
                           std::pair{SQLITE_LIMIT_SQL_LENGTH, kStatement + kPerColumn * columns},
                           std::pair{SQLITE_LIMIT_COLUMN, columns},
                           std::pair{SQLITE_LIMIT_EXPR_DEPTH, 20},
                           std::pair{SQLITE_LIMIT_COMPOUND_SELECT, 3},
                           std::pair{SQLITE_LIMIT_ATTACHED, 0},
                           std::pair{SQLITE_LIMIT_TRIGGER_DEPTH, 1},
                           std::pair{SQLITE_LIMIT_WORKER_THREADS, 0},
                           std::pair{SQLITE_LIMIT_VARIABLE_NUMBER, columns},
                           std::pair{SQLITE_LIMIT_FUNCTION_ARG, 8}};
  for (const auto& [limit, value] : kLimits) sqlite3_limit(handle, limit, value);
  execute("PRAGMA cell_size_check = ON; PRAGMA temp_store = MEMORY; PRAGMA mmap_size = 0");
}

Database::Database(const std::string& file, int columns) {
  sqlite3* handle = nullptr;
  constexpr int kFlags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX |
                         SQLITE_OPEN_EXRESCODE | SQLITE_OPEN_NOFOLLOW;
  const int code = sqlite3_open_v2(file.c_str(), &handle, kFlags, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) fail(handle, code);
  protect(columns);
}

void Database::setBudget(std::int64_t thousands) {
  *budget_ = thousands;
  const auto spend = [](void* budget) { return --*static_cast<std::int64_t*>(budget) < 0 ? 1 : 0; };
  sqlite3_progress_handler(handle_.get(), 1000, spend, budget_.get());
}

void Database::setNoBudget() { sqlite3_progress_handler(handle_.get(), 0, nullptr, nullptr); }

void Database::execute(const char* sql) {
  const int code = sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(handle_.get(), code);
}

std::int64_t Database::integer(std::string_view sql) {
  Statement statement = prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

void Database::checkpointOnClose(bool on) {
  sqlite3_db_config(handle_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, on ? 0 : 1, nullptr);
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const DatabaseError&) {  // SQLite has rolled back by itself after a full disk
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace merker::store
