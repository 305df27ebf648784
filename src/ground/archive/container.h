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
  bool link = false, encrypted = false;
};
// Null if it is no zip. `unpacked` counts the bytes of all files that were opened.
std::shared_ptr<Container> zipContainer(std::shared_ptr<const File> file, const Limits& limits,
                                        std::shared_ptr<std::uint64_t> unpacked,
                                        std::vector<ZipEntry>& entries);

// A zip whose directory is missing or damaged, with one made of its whole files; null if it has
// none. `end`: behind the last of them.
std::shared_ptr<const File> salvaged(const std::shared_ptr<const File>& zip, std::uint64_t& end);

}  // namespace merker::archive
