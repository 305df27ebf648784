#include "project/files.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"

namespace merker::project {
namespace fs = std::filesystem;
namespace {

// The places of a pattern that may come next after a part of the path: all ways at once, so that
// many stars cost no more than few.
class Match {
 public:
  explicit Match(std::string_view pattern) : pattern_(pattern), here_(pattern.size() + 1) {
    reach(0, here_);
  }

  void step(char c) {
    std::vector<char> next(here_.size());
    for (std::size_t i = 0; i < pattern_.size(); ++i)
      if (here_[i] != kNo) step(i, c, next);
    here_ = std::move(next);
  }
  bool done() const { return here_.back() != kNo; }

 private:
  enum Place : char { kNo, kBefore, kInside };  // kInside: within a folder that ** stands for

  bool isFolders(std::size_t i) const { return pattern_.substr(i).starts_with("**/"); }

  void step(std::size_t i, char c, std::vector<char>& next) const {
    if (isFolders(i)) {
      if (c == '/') return reach(i, next);
      if (next[i] == kNo) next[i] = kInside;
    } else if (pattern_[i] == '*') {
      if (c != '/') reach(i, next);
    } else if (pattern_[i] == c || (pattern_[i] == '?' && c != '/')) {
      reach(i + 1, next);
    }
  }

  // Stars may stand for nothing.
  void reach(std::size_t i, std::vector<char>& places) const {
    while (i < places.size() && places[i] != kBefore) {
      places[i] = kBefore;
      if (i == pattern_.size() || pattern_[i] != '*') return;
      i += isFolders(i) ? 3 : 1;
    }
  }

  std::string_view pattern_;
  std::vector<char> here_;
};

// Walks down until there is too much.
class Walk {
 public:
  explicit Walk(Problems* problems) : problems_(problems) {}

  void collect(const std::string& folder, const std::string& prefix, std::size_t depth) {
    for (const Entry& entry : entries(folder)) {
      const std::string path = join(folder, entry.name);
      if (++seen_ > kMostEntries) return tooMuch(ProblemCode::P0714, folder, kMostEntries);
      if (!entry.folder) files.push_back(prefix + entry.name);
      if (!entry.folder || isFile(join(path, "merker.toml"))) continue;
      if (depth == kDeepestFolder) {
        tooMuch(ProblemCode::P0715, path, kDeepestFolder);
        continue;
      }
      collect(path, prefix + entry.name + "/", depth + 1);
      if (seen_ > kMostEntries) return;
    }
  }

  std::vector<std::string> files;

 private:
  void tooMuch(ProblemCode code, const std::string& folder, std::size_t limit) const {
    if (problems_ != nullptr) problems_->add(code, Position{folder}, limit);
  }

  Problems* problems_;
  std::size_t seen_ = 0;
};

}  // namespace

std::vector<Entry> entries(const std::string& folder) {
  std::error_code error;
  std::vector<Entry> list;
  fs::directory_iterator i(folder, error);
  for (const fs::directory_iterator end; !error && i != end; i.increment(error)) {
    if (list.size() > kMostEntries) break;
    std::error_code ignored;
    Entry entry{i->path().filename().string(), i->is_directory(ignored)};
    const bool link = entry.folder && i->is_symlink(ignored);
    if (!link && !entry.name.starts_with('.')) list.push_back(std::move(entry));
  }
  std::sort(list.begin(), list.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  return list;
}

bool matches(std::string_view pattern, std::string_view path) {
  const std::string upperPattern = upper(pattern);
  Match match(upperPattern);
  for (const char c : upper(path)) match.step(c);
  return match.done();
}

std::vector<std::string> listFiles(const std::string& folder, Problems* problems) {
  Walk walk(problems);
  walk.collect(folder, "", 0);
  std::sort(walk.files.begin(), walk.files.end());
  return std::move(walk.files);
}

bool isFolder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool isFile(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

bool hasExtension(std::string_view path, std::string_view extension) {
  return path.size() > extension.size() &&
         equalsIgnoreCase(path.substr(path.size() - extension.size()), extension);
}

std::string join(const std::string& folder, const std::string& name) {
  return (fs::path(folder == "." ? "" : folder) / name).string();
}

std::string folderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string stemOf(const std::string& path) { return fs::path(path).stem().string(); }

}  // namespace merker::project
