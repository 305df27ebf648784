// The two kinds of containers that a tree is made of.
#pragma once

#include <functional>

#include "archive/tree.h"

namespace merker::archive {

// Calls `visit` for each regular file of a folder of the disk, `refuse` for links and what is too
// deep. False from `visit`: stop.
void walkFolder(const std::string& folder, unsigned deepest,
                const std::function<bool(const std::string& path, std::uint64_t size)>& visit,
                const std::function<void(const std::string& path, Refusal why)>& refuse);
std::shared_ptr<Container> diskContainer(std::string folder);

struct ZipEntry {
  std::uint64_t index = 0, size = 0;
  std::string path;  // as it stands in the zip, UTF-8
  bool link = false, encrypted = false, named = true;
};

// What a zip of the disk, with the zips in it, has given so far.
struct Budget {
  std::uint64_t packed = 0;    // bytes of the zip itself
  std::uint64_t unpacked = 0;  // of its files, each counted once
};

// Null if it is no zip. `unpacked` counts the bytes of all files that were opened, in all zips.
std::shared_ptr<Container> zipContainer(std::shared_ptr<const File> file, const Limits& limits,
                                        std::shared_ptr<std::uint64_t> unpacked,
                                        std::shared_ptr<Budget> budget,
                                        std::vector<ZipEntry>& entries);

// The names of the first `most` entries, as far as the directory can be read, and the zip without
// the flags that say what they are encoded in.
struct ZipName {
  std::string text;
  bool valid = true;  // not what it says to be: UTF-8
};
std::shared_ptr<const File> withReadableNames(const std::shared_ptr<const File>& zip,
                                              std::size_t most, std::vector<ZipName>& names);

// A zip whose directory is missing or damaged, with one made of its whole files; null if it has
// none. `end`: behind the last of them.
std::shared_ptr<const File> salvaged(const std::shared_ptr<const File>& zip, std::uint64_t& end);

}  // namespace merker::archive
