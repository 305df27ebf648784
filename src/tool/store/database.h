// A thin cover of SQLite. Its failures are exceptions; memory_card.cpp, and the results of
// campaigns, make problems of them.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace merker::store {

struct DatabaseError : std::runtime_error {
  DatabaseError(int resultCode, const std::string& text)
      : std::runtime_error(text), code(resultCode) {}
  int code;  // primary result code, SQLITE_BUSY …
};

// What SQLite finds in order, but this module does not.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A prepared statement: bind all parameters, then step or run. It must not outlive its database.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);
  Statement& bind(std::int64_t value);
  Statement& bindReal(double value);
  Statement& bindNull();
  Statement& copy(const Statement& row, int column);     // a value of a row of another one
  Statement& bind(std::string_view text);                // copied
  Statement& bind(std::span<const std::uint8_t> bytes);  // must stay until the statement is reset
  bool step();  // true: a row is there; at the end the statement is ready for the next run
  void run();   // to the end
  // Throw Damage if the value is of another type.
  std::int64_t integer(int column) const;
  double real(int column) const;  // or an integer
  bool isNull(int column) const;
  bool isText(int column) const;
  std::string text(int column) const;
  std::vector<std::uint8_t> bytes(int column) const;

 private:
  void require(int column, int type) const;
  void check(int code) const;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int next_ = 1;  // parameter
};

class Database {
 public:
  static constexpr int kColumns = 16;  // of a memory card
  // The path contains no symbolic link. `columns`: the most of a table.
  explicit Database(const std::string& file, int columns = kColumns);
  void execute(const char* sql);
  Statement prepare(std::string_view sql) { return {handle_.get(), sql}; }
  std::int64_t integer(std::string_view sql);  // first column of the first row
  // What lies in the write-ahead log goes into the database when it is closed; switched off, a
  // database that was only looked at stays as it was.
  void checkpointOnClose(bool on);
  // Steps of SQLite's machine, in thousands, that all statements together may take from now on;
  // what takes more fails with SQLITE_INTERRUPT.
  void setBudget(std::int64_t thousands);
  void setNoBudget();

 private:
  void protect(int columns);
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  };
  std::unique_ptr<sqlite3, Close> handle_;
  std::unique_ptr<std::int64_t> budget_ = std::make_unique<std::int64_t>(0);
};

// Everything or nothing: rolled back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {
    database_.execute("BEGIN IMMEDIATE");
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace merker::store
