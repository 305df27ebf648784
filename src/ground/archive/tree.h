// A read-only tree of files: a folder, a zip, or a single file; zips inside are folders of it.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "archive/file.h"

namespace merker::archive {

struct Limits {
  std::size_t entries = 200'000;             // files of the whole tree
  std::uint64_t unpacked = 512u << 20;       // bytes of one file of a zip
  std::uint64_t unpackedInAll = 8ull << 30;  // bytes that a tree unpacks while it lives
  // From here on a file, and all files of a zip, may not be packed tighter than 1 : density.
  std::uint64_t dense = 64u << 20;
  std::uint64_t density = 200;
  unsigned folders = 32;  // within each other
  unsigned zips = 3;      // within each other
};

enum class Refusal : std::uint8_t {
  Unreadable,
  Link,
  LeadsOut,  // its path: "..", a drive, the root
  TooMany,
  TooLarge,
  TooDense,
  TooDeep,
  Encrypted,
  Packing,  // with a method other than those of common zips
  BadName,  // control characters, or not the UTF-8 that it says to be
  Damaged   // a zip: its path says from where on
};
struct Refused {
  std::string path;
  Refusal why;
};

// What files lie in: a folder of the disk or a zip.
class Container {
 public:
  virtual ~Container() = default;
  virtual std::unique_ptr<File> open(std::uint64_t index, const std::string& path,
                                     Refusal& why) = 0;
};

struct Budget;

class Tree {
 public:
  struct Entry {
    std::string path;  // below the root of the tree, with '/'
    std::uint64_t size = 0;
    std::shared_ptr<Container> in;
    std::uint64_t index = 0;  // in its container
  };

  explicit Tree(const std::string& path, const Limits& limits = {});
  // A zip that is open already; without files if it is none.
  explicit Tree(std::unique_ptr<File> zip, const Limits& limits = {});
  // Files in memory, by path.
  explicit Tree(const std::map<std::string, std::string>& files);

  bool readable() const { return readable_; }
  bool isSingleFile() const { return single_; }
  // Sorted by their paths in lower case: what lies in one folder stands together.
  const std::vector<Entry>& files() const { return files_; }
  const Entry* find(std::string_view path) const;
  // All below a folder, "" for the whole tree.
  std::span<const Entry> below(std::string_view folder) const;
  // Null, and a row in refused(), if it cannot be read.
  std::unique_ptr<File> open(const Entry& entry) const;
  std::unique_ptr<File> open(std::string_view path) const;
  const std::vector<Refused>& refused() const { return refused_; }

 private:
  void addFolder(const std::string& path, const std::string& prefix, unsigned depth);
  bool addZip(std::shared_ptr<const File> file, const std::string& path, const std::string& prefix,
              unsigned depth, std::shared_ptr<Budget> budget);
  void addEntry(Entry entry, unsigned zips, const std::shared_ptr<Budget>& budget);
  void refuse(std::string path, Refusal why) const;
  void finish();

  Limits limits_;
  std::shared_ptr<std::uint64_t> unpacked_ = std::make_shared<std::uint64_t>(0);
  std::vector<Entry> files_;
  std::vector<std::string> keys_;  // of files_, in lower case
  mutable std::vector<Refused> refused_;
  bool readable_ = false, single_ = false, full_ = false;
};

// ASCII letters in lower case, '\' as '/'.
std::string folded(std::string_view path);
// The part behind the last '/', and the part before it.
std::string_view nameOf(std::string_view path);
std::string_view folderOf(std::string_view path);

}  // namespace merker::archive
