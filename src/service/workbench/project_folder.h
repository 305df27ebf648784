// The files of a project as browsers may reach them: by paths relative to its folder, never out of
// it. Each folder on the way is opened by itself and never through a link, so that nothing that
// changes on the disk meanwhile leads elsewhere either.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "archive/file.h"
#include "base/result.h"

namespace merker::workbench {

// When a file was changed, as far as one can see without reading it.
struct Stamp {
  std::int64_t changed = 0;  // ns
  std::uint64_t size = 0;
  bool operator==(const Stamp&) const = default;
};

// What is read of a file at most: as long as the longest answer.
constexpr std::size_t kLargestFile = 8 << 20;

using Listing = std::map<std::string, Stamp>;

// A number for a text: the same text, the same number. Exact in JSON.
std::int64_t revisionOf(std::string_view bytes);

class ProjectFolder {
 public:
  struct Content {
    std::string text;
    std::int64_t revision = 0;
  };

  ProjectFolder() = default;
  // `only`: these files and no others, of a program that has no folder of its own.
  explicit ProjectFolder(std::string folder, std::set<std::string> only = {})
      : folder_(std::move(folder)), only_(std::move(only)) {}

  const std::string& folder() const { return folder_; }
  // "merker.toml" from "plant/merker.toml", and back.
  std::string relative(std::string_view path) const;
  std::string full(std::string_view path) const;
  // A text that names files of the folder, with these names relative to it.
  std::string withoutFolder(std::string text) const;

  // What browsers are shown at most.
  static constexpr std::size_t kMostFiles = 5000;
  // P0101 if there is no such folder (any more), or nobody may look into it.
  std::optional<Problem> missing() const;
  // Sorted.
  Listing list(std::size_t most = kMostFiles) const;
  // Open, whatever its length and content; null if there is no such regular file.
  std::unique_ptr<archive::File> file(const std::string& path) const;
  Result<Content> read(const std::string& path) const;
  // Whole or not at all, with the rights that it had. `revision`: of the text it came from; P1311
  // if that is not there any more.
  std::optional<Problem> write(const std::string& path, std::string_view bytes,
                               std::optional<std::int64_t> revision) const;
  // P1312 if it is there already. Folders on the way are made; P1314 for more of them than a
  // program is looked for in.
  std::optional<Problem> create(const std::string& path, std::string_view bytes) const;
  // The same for many: what they are after a power failure is not certain before flush().
  std::optional<Problem> add(const std::string& path, std::string_view bytes) const;
  void flush() const;
  // Whether there can be new files.
  bool growing() const { return only_.empty(); }
  // Folders that nothing is left in go too.
  std::optional<Problem> remove(const std::string& path) const;
  std::optional<Problem> rename(const std::string& from, const std::string& to) const;

  // Whether it may be the path of a file in a project.
  static bool isPath(std::string_view path);

 private:
  std::optional<Problem> make(const std::string& path, std::string_view bytes, bool lasting) const;
  std::optional<Problem> check(const std::string& path) const;
  std::optional<Problem> checkNew(const std::string& path) const;

  std::string folder_;
  std::set<std::string> only_;
};

}  // namespace merker::workbench
