#include "archive/zip_writer.h"

#include <zip.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

namespace merker::archive {
namespace {

// What all files of a zip share while it is written.
struct Progress {
  std::uint64_t most = 0, read = 0;
  const std::stop_token& stop;
  ZipFailure failure = ZipFailure::None;
  std::string path{};

  // Fails once; libzip gives up then.
  zip_int64_t fail(ZipFailure why, zip_error_t& error, const std::string& at = {}) {
    if (failure == ZipFailure::None) failure = why, path = at;
    zip_error_set(&error, ZIP_ER_READ, 0);
    return -1;
  }
};

// One of the files as libzip reads it.
struct Input {
  const Packed& packed;
  Progress& progress;
  std::unique_ptr<File> file{};
  std::uint64_t at = 0;
  zip_error_t error{};

  zip_int64_t open() {
    at = 0;
    file = packed.open();
    return file ? 0 : progress.fail(ZipFailure::Unreadable, error, packed.path);
  }
  zip_int64_t read(void* data, zip_uint64_t length) {
    if (progress.stop.stop_requested()) return progress.fail(ZipFailure::Stopped, error);
    const std::size_t got = file->read(at, {static_cast<std::uint8_t*>(data), length});
    at += got;
    progress.read += got;
    if (progress.read > progress.most) return progress.fail(ZipFailure::TooLarge, error);
    return static_cast<zip_int64_t>(got);
  }
};

zip_int64_t statOf(void* data, zip_uint64_t length, std::uint64_t size) {
  if (length < sizeof(zip_stat_t)) return -1;
  auto* status = static_cast<zip_stat_t*>(data);
  zip_stat_init(status);
  status->valid = ZIP_STAT_SIZE;
  status->size = size;
  return sizeof(zip_stat_t);
}

// Commands that are not named here are not announced, so they do not come.
zip_int64_t serveInput(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command) {
  auto& input = *static_cast<Input*>(user);
  if (command == ZIP_SOURCE_SUPPORTS)
    return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE,
                                          ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
  if (command == ZIP_SOURCE_OPEN) return input.open();
  if (command == ZIP_SOURCE_READ) return input.read(data, length);
  if (command == ZIP_SOURCE_CLOSE) input.file = nullptr;
  if (command == ZIP_SOURCE_STAT) return statOf(data, length, input.packed.size);
  if (command == ZIP_SOURCE_ERROR) return zip_error_to_data(&input.error, data, length);
  if (command == ZIP_SOURCE_FREE) delete &input;
  return 0;
}

// The zip itself: a temporary file without a name. It outlives the zip_t.
struct Output {
  Handle handle{std::tmpfile()};
  zip_error_t error{};

  zip_int64_t failed() {
    zip_error_set(&error, ZIP_ER_WRITE, errno);
    return -1;
  }
  std::uint64_t size() const {
    const auto before = ftello(handle.get());
    fseeko(handle.get(), 0, SEEK_END);
    const auto end = ftello(handle.get());
    fseeko(handle.get(), before, SEEK_SET);
    return static_cast<std::uint64_t>(end);
  }
  zip_int64_t write(const void* data, zip_uint64_t length) {
    return std::fwrite(data, 1, length, handle.get()) == length ? static_cast<zip_int64_t>(length)
                                                                : failed();
  }
  zip_int64_t seek(void* data, zip_uint64_t length) {
    const zip_int64_t to = zip_source_seek_compute_offset(
        static_cast<zip_uint64_t>(ftello(handle.get())), size(), data, length, &error);
    return to >= 0 && fseeko(handle.get(), to, SEEK_SET) == 0 ? 0 : failed();
  }
};

zip_int64_t serveOutput(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command) {
  auto& output = *static_cast<Output*>(user);
  switch (command) {
    case ZIP_SOURCE_SUPPORTS:
      return ZIP_SOURCE_SUPPORTS_WRITABLE;
    case ZIP_SOURCE_STAT:
      return statOf(data, length, output.size());
    case ZIP_SOURCE_WRITE:
      return output.write(data, length);
    case ZIP_SOURCE_SEEK:
    case ZIP_SOURCE_SEEK_WRITE:
      return output.seek(data, length);
    case ZIP_SOURCE_TELL:
    case ZIP_SOURCE_TELL_WRITE:
      return static_cast<zip_int64_t>(ftello(output.handle.get()));
    case ZIP_SOURCE_READ:
      return static_cast<zip_int64_t>(std::fread(data, 1, length, output.handle.get()));
    case ZIP_SOURCE_COMMIT_WRITE:
      return std::fflush(output.handle.get()) == 0 ? 0 : output.failed();
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(&output.error, data, length);
    default:  // of libzip: begin, open, close, roll back, free; the file needs none of them
      return 0;
  }
}

struct DosTime {
  zip_uint16_t time = 0, date = 0;
};

// MS-DOS counts from 1980, in steps of two seconds.
DosTime dosTime(std::int64_t seconds) {
  namespace ch = std::chrono;
  constexpr ch::sys_days kFirst = ch::January / 1 / 1980, kLast = ch::December / 31 / 2107;
  const ch::sys_seconds when(
      ch::seconds{std::clamp<std::int64_t>(seconds, kFirst.time_since_epoch() / ch::seconds(1),
                                           kLast.time_since_epoch() / ch::seconds(1))});
  const auto day = ch::floor<ch::days>(when);
  const ch::year_month_day date(day);
  const ch::hh_mm_ss clock(when - day);
  constexpr int kYear = 9, kMonth = 5, kHour = 11, kMinute = 5;  // first bits
  const int years = static_cast<int>(date.year()) - 1980;
  return {
      static_cast<zip_uint16_t>(clock.hours().count() << kHour |
                                clock.minutes().count() << kMinute | clock.seconds().count() / 2),
      static_cast<zip_uint16_t>(years << kYear |
                                static_cast<int>(unsigned{date.month()}) << kMonth |
                                static_cast<int>(unsigned{date.day()}))};
}

bool add(zip_t* zip, const Packed& packed, Progress& progress) {
  auto input = std::make_unique<Input>(Input{packed, progress});
  zip_source_t* source = zip_source_function(zip, serveInput, input.get());
  if (source == nullptr) return false;
  static_cast<void>(input.release());  // the source's, from here on
  const zip_int64_t index = zip_file_add(zip, packed.path.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const DosTime when = dosTime(packed.changed);
  constexpr zip_uint32_t kRegular = 0100644u << 16;  // of Unix, in the upper half
  const auto number = static_cast<zip_uint64_t>(index);
  return zip_file_set_dostime(zip, number, when.time, when.date, 0) == 0 &&
         zip_file_set_external_attributes(zip, number, 0, ZIP_OPSYS_UNIX, kRegular) == 0;
}

}  // namespace

Zipped writeZip(const std::vector<Packed>& files, std::uint64_t most, const std::stop_token& stop) {
  Output output;
  if (!output.handle) return {nullptr, ZipFailure::Unwritable, {}};
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_function_create(serveOutput, &output, &error);
  if (target == nullptr) return {nullptr, ZipFailure::Unwritable, {}};
  zip_t* zip = zip_open_from_source(target, ZIP_CREATE | ZIP_TRUNCATE, &error);
  if (zip == nullptr) {
    zip_source_free(target);
    return {nullptr, ZipFailure::Unwritable, {}};
  }
  Progress progress{most, 0, stop};
  const bool added =
      std::ranges::all_of(files, [&](const Packed& packed) { return add(zip, packed, progress); });
  if (!added || zip_close(zip) != 0) {
    zip_discard(zip);
    const bool told = progress.failure != ZipFailure::None;
    return {nullptr, told ? progress.failure : ZipFailure::Unwritable, progress.path};
  }
  return {fileOn(std::move(output.handle)), ZipFailure::None, {}};
}

}  // namespace merker::archive
