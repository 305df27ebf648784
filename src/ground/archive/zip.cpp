#include <zip.h>

#include <algorithm>
#include <map>

#include "archive/container.h"

namespace merker::archive {
namespace {

constexpr std::size_t kPiece = 64u << 10;
constexpr std::uint64_t kInMemory = 1u << 20;  // larger files are unpacked into a temporary file

// A file of ours as libzip reads it.
struct Source {
  std::shared_ptr<const File> file;
  std::uint64_t at = 0;
  zip_error_t error{};
};

zip_int64_t stat(const Source& source, void* data, zip_uint64_t length) {
  if (length < sizeof(zip_stat_t)) return -1;
  auto* status = static_cast<zip_stat_t*>(data);
  zip_stat_init(status);
  status->valid = ZIP_STAT_SIZE;
  status->size = source.file->size();
  return sizeof(zip_stat_t);
}

zip_int64_t seek(Source& source, void* data, zip_uint64_t length) {
  const zip_int64_t to =
      zip_source_seek_compute_offset(source.at, source.file->size(), data, length, &source.error);
  if (to < 0) return -1;
  source.at = static_cast<std::uint64_t>(to);
  return 0;
}

zip_int64_t serve(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command) {
  auto& source = *static_cast<Source*>(user);
  switch (command) {
    case ZIP_SOURCE_SUPPORTS:
      return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE,
                                            ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE,
                                            ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, -1);
    case ZIP_SOURCE_OPEN:
      source.at = 0;
      return 0;
    case ZIP_SOURCE_READ: {
      const std::size_t got =
          source.file->read(source.at, {static_cast<std::uint8_t*>(data), length});
      source.at += got;
      return static_cast<zip_int64_t>(got);
    }
    case ZIP_SOURCE_STAT:
      return stat(source, data, length);
    case ZIP_SOURCE_SEEK:
      return seek(source, data, length);
    case ZIP_SOURCE_TELL:
      return static_cast<zip_int64_t>(source.at);
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(&source.error, data, length);
    case ZIP_SOURCE_FREE:
      delete &source;
      return 0;
    default:
      return 0;
  }
}

struct CloseEntry {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

// Where the bytes of an entry go: memory, or a temporary file from kInMemory on.
class Unpacked {
 public:
  bool add(std::span<const std::uint8_t> piece) {
    if (!spool_ && bytes_.size() + piece.size() > kInMemory && !spill()) return false;
    if (spool_) return std::fwrite(piece.data(), 1, piece.size(), spool_.get()) == piece.size();
    bytes_.insert(bytes_.end(), piece.begin(), piece.end());
    return true;
  }
  std::unique_ptr<File> take() {
    if (!spool_) return fileOf(std::move(bytes_));
    return std::fflush(spool_.get()) == 0 ? fileOn(std::move(spool_)) : nullptr;
  }

 private:
  bool spill() {
    spool_ = Handle(std::tmpfile());
    if (!spool_ || std::fwrite(bytes_.data(), 1, bytes_.size(), spool_.get()) != bytes_.size())
      return false;
    bytes_ = {};
    return true;
  }
  std::vector<std::uint8_t> bytes_;
  Handle spool_;
};

class Zip final : public Container {
 public:
  Zip(zip_t* zip, const Limits& limits, std::shared_ptr<std::uint64_t> unpacked,
      std::shared_ptr<Budget> budget)
      : zip_(zip), limits_(limits), unpacked_(std::move(unpacked)), budget_(std::move(budget)) {}
  Zip(const Zip&) = delete;
  ~Zip() override { zip_discard(zip_); }

  std::unique_ptr<File> open(std::uint64_t index, const std::string&, Refusal& why) override {
    why = Refusal::Unreadable;
    zip_stat_t status;
    zip_stat_init(&status);
    if (zip_stat_index(zip_, index, 0, &status) != 0) return nullptr;
    const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen_index(zip_, index, 0));
    if (!file) {
      if (zip_error_code_zip(zip_get_error(zip_)) == ZIP_ER_COMPNOTSUPP) why = Refusal::Packing;
      return nullptr;
    }
    // What the directory says about the length may be wrong: only what comes out counts.
    Unpacked out;
    std::vector<std::uint8_t> piece(kPiece);
    std::uint64_t size = 0;
    while (true) {
      const zip_int64_t got = zip_fread(file.get(), piece.data(), piece.size());
      if (got < 0) return nullptr;
      if (got == 0) return out.take();
      size += static_cast<std::uint64_t>(got);
      *unpacked_ += static_cast<std::uint64_t>(got);
      count(index, size);
      if (!allowed(size, status.comp_size, why)) {
        forget(index);
        return nullptr;
      }
      if (!out.add({piece.data(), static_cast<std::size_t>(got)})) return nullptr;
    }
  }

 private:
  // A file that is opened again does not count again.
  void count(std::uint64_t index, std::uint64_t size) {
    std::uint64_t& counted = sizes_[index];
    if (size <= counted) return;
    budget_->unpacked += size - counted;
    counted = size;
  }
  // A file that is refused must not cost the others.
  void forget(std::uint64_t index) {
    budget_->unpacked -= sizes_[index];
    sizes_[index] = 0;
  }
  bool tooDense(std::uint64_t size, std::uint64_t packed) const {
    return size > limits_.dense && size / limits_.density > packed;
  }
  bool allowed(std::uint64_t size, std::uint64_t packed, Refusal& why) const {
    // Files may share their packed bytes: what all give counts as well.
    const bool dense = tooDense(size, packed) || tooDense(budget_->unpacked, budget_->packed);
    if (dense) why = Refusal::TooDense;
    const bool large = size > limits_.unpacked || *unpacked_ > limits_.unpackedInAll;
    if (large) why = Refusal::TooLarge;
    return !dense && !large;
  }

  zip_t* zip_;
  Limits limits_;
  std::shared_ptr<std::uint64_t> unpacked_;
  std::shared_ptr<Budget> budget_;
  std::map<std::uint64_t, std::uint64_t> sizes_;  // of the files that were opened
};

ZipEntry entryOf(zip_t* zip, std::uint64_t index, const ZipName& name, const zip_stat_t& status) {
  ZipEntry entry;
  entry.index = index;
  entry.path = name.text;
  entry.named = name.valid;
  if ((status.valid & ZIP_STAT_SIZE) != 0) entry.size = status.size;
  entry.encrypted =
      (status.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && status.encryption_method != ZIP_EM_NONE;
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  constexpr std::uint32_t kKind = 0170000, kLink = 0120000;  // of Unix, in the upper half
  entry.link = zip_file_get_external_attributes(zip, index, 0, &system, &attributes) == 0 &&
               system == ZIP_OPSYS_UNIX && (attributes >> 16 & kKind) == kLink;
  return entry;
}

}  // namespace

std::shared_ptr<Container> zipContainer(std::shared_ptr<const File> file, const Limits& limits,
                                        std::shared_ptr<std::uint64_t> unpacked,
                                        std::shared_ptr<Budget> budget,
                                        std::vector<ZipEntry>& entries) {
  std::vector<ZipName> names;
  file = withReadableNames(file, limits.entries + 1, names);
  zip_error_t error;
  zip_error_init(&error);
  auto* state = new Source{std::move(file), 0, {}};
  zip_source_t* source = zip_source_function_create(serve, state, &error);
  if (source == nullptr) {
    delete state;
    return nullptr;
  }
  zip_t* zip = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (zip == nullptr) {
    zip_source_free(source);
    return nullptr;
  }
  auto container = std::make_shared<Zip>(zip, limits, std::move(unpacked), std::move(budget));
  const auto count =
      static_cast<std::uint64_t>(std::max<zip_int64_t>(0, zip_get_num_entries(zip, 0)));
  for (std::uint64_t i = 0; i < count && entries.size() <= limits.entries; ++i) {
    zip_stat_t status;
    zip_stat_init(&status);
    const char* name = zip_get_name(zip, i, ZIP_FL_ENC_GUESS);
    if (name == nullptr || zip_stat_index(zip, i, 0, &status) != 0) continue;
    entries.push_back(entryOf(zip, i, i < names.size() ? names[i] : ZipName{name}, status));
  }
  return container;
}

}  // namespace merker::archive
