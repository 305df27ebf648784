// The names of a zip as its directory has them. One that breaks its promise to be UTF-8 would cost
// the whole zip: libzip refuses such a directory.
#include <algorithm>
#include <array>
#include <optional>

#include "archive/container.h"
#include "base/text.h"
#include "base/utf8.h"

namespace merker::archive {
namespace {

constexpr std::uint32_t kCentralMark = 0x02014B50, kEndMark = 0x06054B50;
constexpr std::uint32_t kLongEndMark = 0x06064B50, kLocatorMark = 0x07064B50;
constexpr std::size_t kCentralBytes = 46, kEndBytes = 22, kLongEndBytes = 56, kLocatorBytes = 20;
constexpr std::size_t kLongestComment = 0xFFFF, kFlagsAt = 8;
constexpr unsigned kIsUtf8 = 0x800;  // flag: the name is UTF-8, else it is in code page 437

std::uint64_t number(const std::uint8_t* from, unsigned count) {
  std::uint64_t value = 0;
  for (unsigned i = count; i-- > 0;) value = value << 8 | from[i];
  return value;
}

struct Directory {
  std::uint64_t at = 0, count = 0;
};

// Of a zip with more than 65,535 files or 4 GB, whose end has a longer one before it.
std::optional<Directory> longDirectory(const File& file, std::uint64_t end) {
  std::array<std::uint8_t, kLocatorBytes> locator{};
  if (end < kLocatorBytes || file.read(end - kLocatorBytes, locator) < kLocatorBytes ||
      number(locator.data(), 4) != kLocatorMark)
    return std::nullopt;
  std::array<std::uint8_t, kLongEndBytes> bytes{};
  const std::uint64_t at = number(&locator[8], 8);
  if (at > file.size() || file.read(at, bytes) < kLongEndBytes ||
      number(bytes.data(), 4) != kLongEndMark)
    return std::nullopt;
  return Directory{number(&bytes[48], 8), number(&bytes[32], 8)};
}

std::optional<Directory> directoryOf(const File& file) {
  std::vector<std::uint8_t> tail(std::min<std::uint64_t>(file.size(), kEndBytes + kLongestComment));
  const std::uint64_t from = file.size() - tail.size();
  if (tail.size() < kEndBytes || file.read(from, tail) < tail.size()) return std::nullopt;
  for (std::size_t i = tail.size() - kEndBytes + 1; i-- > 0;) {
    if (number(&tail[i], 4) != kEndMark) continue;
    if (const auto longer = longDirectory(file, from + i)) return longer;
    return Directory{number(&tail[i + 16], 4), number(&tail[i + 10], 2)};
  }
  return std::nullopt;
}

// The same file; in some bytes, the flags of names, the bit for UTF-8 is missing.
class Unflagged final : public File {
 public:
  Unflagged(std::shared_ptr<const File> file, std::vector<std::uint64_t> places)
      : file_(std::move(file)), places_(std::move(places)) {}
  std::uint64_t size() const override { return file_->size(); }
  std::size_t read(std::uint64_t at, std::span<std::uint8_t> to) const override {
    const std::size_t got = file_->read(at, to);
    for (auto place = std::ranges::lower_bound(places_, at);
         place != places_.end() && *place < at + got; ++place)
      to[*place - at] &= static_cast<std::uint8_t>(~(kIsUtf8 >> 8));
    return got;
  }

 private:
  std::shared_ptr<const File> file_;
  std::vector<std::uint64_t> places_;  // sorted
};

}  // namespace

std::shared_ptr<const File> withReadableNames(const std::shared_ptr<const File>& zip,
                                              std::size_t most, std::vector<ZipName>& names) {
  const auto directory = directoryOf(*zip);
  if (!directory) return zip;
  std::vector<std::uint64_t> flags;
  std::uint64_t at = directory->at;
  for (std::uint64_t i = 0; i < directory->count; ++i) {
    std::array<std::uint8_t, kCentralBytes> head{};
    if (at > zip->size() || zip->read(at, head) < head.size() ||
        number(head.data(), 4) != kCentralMark)
      break;
    std::string name(number(&head[28], 2), '\0');
    const std::span bytes(reinterpret_cast<std::uint8_t*>(name.data()), name.size());
    if (zip->read(at + kCentralBytes, bytes) < bytes.size()) break;
    const bool flagged = (number(&head[kFlagsAt], 2) & kIsUtf8) != 0;
    if (flagged) flags.push_back(at + kFlagsAt + 1);
    const bool valid = isValidUtf8(name);
    if (names.size() < most)
      names.push_back({valid || flagged ? name : toUtf8(name, Encoding::Cp437), valid || !flagged});
    at += kCentralBytes + name.size() + number(&head[30], 2) + number(&head[32], 2);
  }
  if (flags.empty()) return zip;
  return std::make_shared<Unflagged>(zip, std::move(flags));
}

}  // namespace merker::archive
