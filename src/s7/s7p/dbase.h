// dBase tables (.DBF) and their memos (.DBT), read row by row (docs/formats/s7p.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "archive/tree.h"
#include "s7p/fault.h"

namespace merker::s7p {

class Table {
 public:
  // Empty if the file is none.
  explicit Table(std::unique_ptr<archive::File> file);

  bool good() const { return rowLength_ > 0; }
  // What the header counts and the file does not hold.
  std::uint64_t missingRows() const { return missing_; }
  // The next row that is not deleted. A short last row ends the table.
  bool next();
  // Of the row: bytes of the column as they are; empty if there is no such column.
  std::string_view bytes(std::string_view column) const;
  // Without blanks and NUL around it.
  std::string_view text(std::string_view column) const;
  std::optional<std::uint32_t> number(std::string_view column) const;
  std::uint32_t numberOr(std::string_view column, std::uint32_t other) const {
    return number(column).value_or(other);
  }

 private:
  struct Column {
    std::string name;
    std::size_t at = 0, length = 0;
  };
  bool readHeader();
  bool fill();

  std::unique_ptr<archive::File> file_;
  std::vector<Column> columns_;
  std::size_t rowLength_ = 0;
  std::uint64_t at_ = 0;    // in the file, of the next rows to read
  std::uint64_t rows_ = 0;  // still to come
  std::uint64_t missing_ = 0;
  std::vector<std::uint8_t> piece_;
  std::size_t inPiece_ = 0, pieceRows_ = 0;
  std::string_view row_;
};

// Also what is wrong with the table as a whole: NoTable, CutTable.
Table openTable(const archive::Tree& tree, const std::string& path, Faults& faults);

class Memo {
 public:
  Memo() = default;
  explicit Memo(std::unique_ptr<archive::File> file);
  bool good() const { return file_ != nullptr; }
  // The content that the block of this number begins, at most `most` bytes; nothing if there is no
  // such memo. 0: none.
  std::optional<std::vector<std::uint8_t>> read(std::uint32_t block, std::size_t most) const;

 private:
  std::unique_ptr<archive::File> file_;
  std::uint32_t blockSize_ = 512;
};

}  // namespace merker::s7p
