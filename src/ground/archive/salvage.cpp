// A zip without its directory, which stands at its end: each file has a header of its own as well,
// and from those a new directory is made.
#include <algorithm>
#include <array>
#include <optional>

#include "archive/container.h"

namespace merker::archive {
namespace {

constexpr std::uint32_t kLocal = 0x04034B50, kCentral = 0x02014B50, kEnd = 0x06054B50;
constexpr std::uint32_t kDescriptor = 0x08074B50;
constexpr std::size_t kLocalBytes = 30, kDescriptorBytes = 16, kMostFiles = 0xFFFF;
constexpr std::size_t kFirstPiece = 512, kPiece = 64u << 10;
constexpr unsigned kSizesFollow = 8;  // flag: sum and sizes stand behind the file

using Bytes = std::vector<std::uint8_t>;

std::uint32_t little(const std::uint8_t* from, unsigned count) {
  std::uint32_t value = 0;
  for (unsigned i = count; i-- > 0;) value = value << 8 | from[i];
  return value;
}

void put(Bytes& out, std::uint32_t value, unsigned count) {
  for (unsigned i = 0; i < count; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

struct Entry {
  std::uint64_t at = 0, data = 0, end = 0;
  std::array<std::uint8_t, kLocalBytes> head{};  // with sum and sizes
  std::string name;

  std::uint32_t field(std::size_t offset, unsigned count) const {
    return little(&head[offset], count);
  }
  std::uint32_t packed() const { return field(18, 4); }
};

class Scanner {
 public:
  explicit Scanner(const File& file) : file_(file) {}

  // Ends at the first byte that belongs to no whole file.
  std::vector<Entry> scan(std::uint64_t& end) {
    std::vector<Entry> found;
    for (auto at = next(0, kLocal); at && found.size() < kMostFiles; at = next(*at, kLocal)) {
      auto entry = read(*at);
      if (entry) end = entry->end;
      at = entry ? entry->end : *at + 4;
      if (entry) found.push_back(std::move(*entry));
    }
    return found;
  }

 private:
  // Where the mark stands from `from` on.
  std::optional<std::uint64_t> next(std::uint64_t from, std::uint32_t mark) {
    Bytes piece(kFirstPiece);
    while (from + 4 <= file_.size() && budget_ > 0) {
      const std::size_t got = file_.read(from, piece);
      budget_ -= std::min<std::uint64_t>(budget_, got);
      for (std::size_t i = 0; i + 4 <= got; ++i)
        if (piece[i] == 'P' && little(&piece[i], 4) == mark) return from + i;
      if (got < piece.size()) break;
      from += got - 3;
      piece.resize(std::min(2 * piece.size(), kPiece));
    }
    return std::nullopt;
  }

  std::optional<Entry> read(std::uint64_t at) {
    Entry entry;
    entry.at = at;
    if (file_.read(at, entry.head) < kLocalBytes) return std::nullopt;
    entry.name.resize(entry.field(26, 2));
    const std::span name(reinterpret_cast<std::uint8_t*>(entry.name.data()), entry.name.size());
    if (file_.read(at + kLocalBytes, name) < name.size()) return std::nullopt;
    entry.data = at + kLocalBytes + name.size() + entry.field(28, 2);
    const bool follow = (entry.field(6, 2) & kSizesFollow) != 0 && entry.packed() == 0;
    if (follow && !sizesBehind(entry)) return std::nullopt;
    if (!follow) entry.end = entry.data + entry.packed();
    return entry.end <= file_.size() ? std::optional(std::move(entry)) : std::nullopt;
  }

  // The descriptor behind a file: its packed size is the distance.
  bool sizesBehind(Entry& entry) {
    for (auto at = next(entry.data, kDescriptor); at; at = next(*at + 4, kDescriptor)) {
      std::array<std::uint8_t, kDescriptorBytes> bytes{};
      if (file_.read(*at, bytes) < bytes.size()) return false;
      if (little(&bytes[8], 4) != *at - entry.data) continue;
      std::copy_n(&bytes[4], 12, &entry.head[14]);
      entry.end = *at + bytes.size();
      return true;
    }
    return false;
  }

  const File& file_;
  // Bytes to look at: marks that begin no file must not make the search long.
  std::uint64_t budget_ = 8 * file_.size() + kPiece;
};

Bytes directoryOf(const std::vector<Entry>& entries, std::uint64_t at) {
  constexpr std::uint32_t kVersion = 20;
  Bytes out;
  for (const Entry& entry : entries) {
    put(out, kCentral, 4);
    put(out, kVersion, 2);
    out.insert(out.end(), &entry.head[4], &entry.head[28]);  // version to length of the name
    for (const unsigned count : {2u, 2u, 2u, 2u, 4u}) put(out, 0, count);
    put(out, static_cast<std::uint32_t>(entry.at), 4);
    out.insert(out.end(), entry.name.begin(), entry.name.end());
  }
  const auto size = static_cast<std::uint32_t>(out.size());
  put(out, kEnd, 4);
  put(out, 0, 4);
  for (int i = 0; i < 2; ++i) put(out, static_cast<std::uint32_t>(entries.size()), 2);
  put(out, size, 4);
  put(out, static_cast<std::uint32_t>(at), 4);
  put(out, 0, 2);
  return out;
}

// The first bytes of a file, and others behind them.
class Extended final : public File {
 public:
  Extended(std::shared_ptr<const File> front, std::uint64_t length, Bytes tail)
      : front_(std::move(front)), length_(length), tail_(std::move(tail)) {}
  std::uint64_t size() const override { return length_ + tail_.size(); }
  std::size_t read(std::uint64_t at, std::span<std::uint8_t> to) const override {
    std::size_t got = 0;
    if (at < length_) {
      const std::size_t count = std::min<std::uint64_t>(to.size(), length_ - at);
      got = front_->read(at, to.first(count));
      if (got < count) return got;
    }
    if (at + got < length_ || at + got >= size()) return got;
    const std::size_t from = at + got - length_;
    const std::size_t count = std::min(to.size() - got, tail_.size() - from);
    std::copy_n(tail_.begin() + static_cast<std::ptrdiff_t>(from), count, to.data() + got);
    return got + count;
  }

 private:
  std::shared_ptr<const File> front_;
  std::uint64_t length_;
  Bytes tail_;
};

}  // namespace

std::shared_ptr<const File> salvaged(const std::shared_ptr<const File>& zip, std::uint64_t& end) {
  constexpr std::uint64_t kLargest = 0xFFFF'0000;  // offsets of four bytes
  end = 0;
  if (zip->size() > kLargest) return nullptr;
  const std::vector<Entry> entries = Scanner(*zip).scan(end);
  if (entries.empty()) return nullptr;
  return std::make_shared<Extended>(zip, end, directoryOf(entries, end));
}

}  // namespace merker::archive
