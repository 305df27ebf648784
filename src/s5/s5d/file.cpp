#include "s5d/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace merker::s5d {
namespace {

constexpr std::size_t kHeader = 5;      // words of a block without a body
constexpr std::uint16_t kEnd = 0x6500;  // BE

std::size_t lengthField(const Kind& kind, Bytes block) {
  return 2u * wordAt(block, kind.sync ? kLength : kPreLength);
}

Record recordAt(Bytes file, std::size_t offset) {
  Record record;
  record.offset = offset;
  const Bytes rest = file.subspan(offset);
  record.kind = kindAt(rest);
  std::size_t length = record.kind == nullptr ? 0 : lengthField(*record.kind, rest);
  if (length == 0) length = kRecord;
  if (record.kind != nullptr)
    record.number = byteAt(rest, record.kind->sync ? kNumber : kPreNumber);
  record.cut = record.kind != nullptr && length > rest.size();
  record.bytes = rest.first(std::min(length, rest.size()));
  return record;
}

// What nobody names must look sound: section 1.4 of the requirements.
bool isSound(const Record& record) {
  if (record.kind == nullptr || record.cut || record.bytes.size() < 2 * kHeader) return false;
  if (!record.kind->sync) return lengthField(*record.kind, record.bytes) != 0;
  if (lengthField(*record.kind, record.bytes) < 2 * kHeader) return false;
  const bool code = record.kind->group == Group::Code;
  return !code || wordAt(record.bytes, record.bytes.size() - 2) == kEnd;
}

bool isSoundBlock(const Record& record) {
  return isSound(record) &&
         (record.kind->group == Group::Code || record.kind->group == Group::Data);
}

// Its name can be read, or the first section begins where the data do.
bool hasHeader(Bytes file) {
  const Bytes name = file.subspan(kName, kNameLength);
  const bool text = std::ranges::all_of(name, [](auto byte) { return byte >= ' ' && byte < 0x7F; });
  const bool blank = std::ranges::all_of(name, [](auto byte) { return byte == ' '; });
  const std::size_t first = littleAt(file, kDirectory + kSectionRecord);
  return (text && !blank) || (first != 0 && first == file[kHeaderRecords]);
}

std::string trimmed(Bytes bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes)
    text += byte >= ' ' && byte < 0x7F ? static_cast<char>(byte) : ' ';
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

class Reader {
 public:
  explicit Reader(Bytes file) : file_(file.first(std::min(file.size(), kLargestFile))) {}

  File read() {
    if (file_.size() < kRecord) return std::move(result_);
    result_.name = trimmed(file_.subspan(kName, kNameLength));
    const std::size_t sections = hasHeader(file_) ? file_[kCount] : 0u;
    for (std::size_t i = 0; i < sections; ++i) section(kDirectory + i * kSectionEntry);
    const bool usable = std::ranges::any_of(result_.records, isSoundBlock);
    if (!usable) seen_.clear();
    // A header that leads to no block does not say either where the data begin.
    scan(usable ? std::max<std::size_t>(file_[kHeaderRecords], 1) : 1);
    if (usable || result_.deleted.empty()) return std::move(result_);
    result_.withoutDirectory = true;
    result_.records.swap(result_.deleted);
    result_.deleted.clear();
    return std::move(result_);
  }

 private:
  void section(std::size_t entry) {
    const std::size_t start = littleAt(file_, entry + kSectionRecord) * kRecord;
    const std::size_t header = byteAt(file_, start + kHeaderRecords) * kRecord;
    if (start < kRecord || header == 0 || start + header >= file_.size()) {
      ++result_.badSections;
      return;
    }
    std::size_t at = start + header;
    for (std::size_t i = 0; i < file_[start + kCount] && at < file_.size(); ++i) {
      if (!seen_.insert(at).second) return;  // two entries with the same section
      result_.records.push_back(recordAt(file_, at));
      // Sections that overlap would be read over and over.
      read_ += result_.records.back().bytes.size();
      if (read_ > file_.size()) return;
      at += recordsFor(result_.records.back().bytes.size()) * kRecord;
    }
  }

  void scan(std::size_t firstRecord) {
    std::size_t at = firstRecord * kRecord;
    while (at < file_.size()) {
      const Record record = recordAt(file_, at);
      if (!isSound(record)) {
        at += kRecord;
        continue;
      }
      if (!seen_.contains(at)) result_.deleted.push_back(record);
      at += recordsFor(record.bytes.size()) * kRecord;
    }
  }

  Bytes file_;
  File result_;
  std::set<std::size_t> seen_;
  std::size_t read_ = 0;  // bytes of blocks
};

}  // namespace

std::string Record::name() const {
  if (kind == nullptr) return fmt::format("record {}", offset / kRecord);
  return fmt::format("{} {}", kind->name, number);
}

bool isS5d(Bytes file) {
  if (file.size() < 2 * kRecord || file.size() > kLargestFile) return false;
  return std::ranges::any_of(readFile(file).records, isSoundBlock);
}

File readFile(Bytes file) { return Reader(file).read(); }

}  // namespace merker::s5d
