#include "s7p/dbase.h"

#include <algorithm>
#include <charconv>

#include "s7p/fault.h"

namespace merker::s7p {
namespace {

// Places in the header of a table, and of a field in it.
constexpr std::size_t kRowsAt = 4, kHeaderLengthAt = 8, kRowLengthAt = 10, kHeader = 32;
constexpr std::size_t kFieldLengthAt = 16, kField = 32, kFieldName = 11;
constexpr std::uint8_t kEndOfFields = 0x0D, kDeleted = '*';
constexpr std::size_t kMostFields = 255, kPiece = 64u << 10;
// A memo begins with these bytes and its length with them.
constexpr std::size_t kMemoHeader = 8, kMemoBlockSizeAt = 20;
constexpr std::uint32_t kSmallestBlock = 64, kLargestBlock = 32768;

std::uint32_t little(const std::uint8_t* from, std::size_t bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes; i-- > 0;) value = value << 8 | from[i];
  return value;
}

constexpr std::string_view kAround{" \0\t\r\n", 5};

}  // namespace

Table::Table(std::unique_ptr<archive::File> file) : file_(std::move(file)) {
  if (!file_ || !readHeader()) rowLength_ = 0;
}

bool Table::readHeader() {
  std::vector<std::uint8_t> header(kHeader + kMostFields * kField + 1);
  header.resize(file_->read(0, header));
  if (header.size() <= kHeader) return false;
  rows_ = little(&header[kRowsAt], 4);
  at_ = little(&header[kHeaderLengthAt], 2);
  rowLength_ = little(&header[kRowLengthAt], 2);
  std::size_t place = 1;  // behind the mark of a deleted row
  for (std::size_t i = kHeader; i + kField <= header.size() && header[i] != kEndOfFields;
       i += kField) {
    const auto* name = reinterpret_cast<const char*>(&header[i]);
    Column column{std::string(name, std::find(name, name + kFieldName, '\0')), place,
                  header[i + kFieldLengthAt]};
    place += column.length;
    columns_.push_back(std::move(column));
  }
  if (columns_.empty() || place > rowLength_ || at_ <= kHeader) return false;
  const std::uint64_t there = file_->size() > at_ ? (file_->size() - at_) / rowLength_ : 0;
  missing_ = rows_ - std::min(rows_, there);
  return true;
}

bool Table::fill() {
  piece_.resize(std::max<std::size_t>(1, kPiece / rowLength_) * rowLength_);
  const std::size_t got = file_->read(at_, piece_);
  pieceRows_ = static_cast<std::size_t>(std::min<std::uint64_t>(got / rowLength_, rows_));
  at_ += pieceRows_ * rowLength_;
  rows_ -= pieceRows_;
  inPiece_ = 0;
  return pieceRows_ > 0;
}

bool Table::next() {
  while (good()) {
    if (inPiece_ == pieceRows_ && (rows_ == 0 || !fill())) break;
    const auto* row = reinterpret_cast<const char*>(&piece_[inPiece_++ * rowLength_]);
    if (static_cast<std::uint8_t>(*row) == kDeleted) continue;
    row_ = {row, rowLength_};
    return true;
  }
  row_ = {};
  return false;
}

std::string_view Table::bytes(std::string_view column) const {
  for (const Column& c : columns_)
    if (c.name == column && !row_.empty()) return row_.substr(c.at, c.length);
  return {};
}

std::string_view Table::text(std::string_view column) const {
  std::string_view value = bytes(column);
  value = value.substr(0, value.find('\0'));
  const std::size_t first = value.find_first_not_of(kAround);
  if (first == std::string_view::npos) return {};
  return value.substr(first, value.find_last_not_of(kAround) - first + 1);
}

std::optional<std::uint32_t> Table::number(std::string_view column) const {
  const std::string_view value = text(column);
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size()) return std::nullopt;
  return number;
}

Table openTable(const archive::Tree& tree, const std::string& path, Faults& faults) {
  Table table(tree.open(path));
  if (!table.good())
    faults.push_back({FaultKind::NoTable, path, {}});
  else if (table.missingRows() > 0)
    faults.push_back({FaultKind::CutTable, path, std::to_string(table.missingRows())});
  return table;
}

Memo::Memo(std::unique_ptr<archive::File> file) : file_(std::move(file)) {
  std::uint8_t header[kMemoBlockSizeAt + 2] = {};
  if (!file_) return;
  if (file_->read(0, header) < sizeof(header)) {
    file_.reset();
    return;
  }
  const std::uint32_t size = little(header + kMemoBlockSizeAt, 2);
  if (size >= kSmallestBlock && size <= kLargestBlock) blockSize_ = size;
}

std::optional<std::vector<std::uint8_t>> Memo::read(std::uint32_t block, std::size_t most) const {
  if (!file_ || block == 0) return std::nullopt;
  const std::uint64_t at = std::uint64_t{block} * blockSize_;
  std::uint8_t header[kMemoHeader] = {};
  if (file_->read(at, header) < kMemoHeader) return std::nullopt;
  if (header[0] != 0xFF || header[1] != 0xFF || header[2] != 0x08) return std::nullopt;
  const std::uint64_t length = little(header + 4, 4);
  if (length < kMemoHeader) return std::nullopt;
  const std::uint64_t wanted = std::min<std::uint64_t>(length - kMemoHeader, most);
  if (at + kMemoHeader + wanted > file_->size()) return std::nullopt;
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(wanted));
  bytes.resize(file_->read(at + kMemoHeader, bytes));
  return bytes;
}

}  // namespace merker::s7p
