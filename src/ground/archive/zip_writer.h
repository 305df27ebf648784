// Writes a zip: the same files give the same bytes, whatever the machine and its time zone.
#pragma once

#include <functional>
#include <stop_token>

#include "archive/file.h"

namespace merker::archive {

// A file of the zip. It is opened when its turn comes, so that any number of them can be named.
struct Packed {
  std::string path;          // with '/'
  std::uint64_t size = 0;    // as far as known; what is read counts
  std::int64_t changed = 0;  // seconds since 1970, UTC; before 1980 a zip has no time: 1980 then
  std::function<std::unique_ptr<File>()> open;  // null: it cannot be read, and there is no zip
};

enum class ZipFailure : std::uint8_t { None, TooLarge, Unreadable, Unwritable, Stopped };

struct Zipped {
  std::unique_ptr<File> file;  // without a name: gone with its last user, also when he is killed
  ZipFailure failure = ZipFailure::None;
  std::string path;  // of the file that cannot be read
};

// `most`: bytes of all files before they are packed.
Zipped writeZip(const std::vector<Packed>& files, std::uint64_t most, const std::stop_token& stop);

}  // namespace merker::archive
